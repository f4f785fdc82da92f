#!/usr/bin/env perl
# rtl.pl TREE WARNINGS CLOCK[,CLOCK]...[:RESET] [NETLIST]
#
# Reads the tree of a design that Verilator wrote, what `verilator --lint-only` said of it, and what
# rtl_yosys.pl found. On standard output, a line each:
#
#   register NAME WIDTH WORDS BITS [NET WIDTH WORDS LOW]...
#                      a register, by its path below the top, its bits, those of a word of a memory,
#                      and its words, 0 where it is no memory, -1 where no table can have it; those of
#                      its bits that hold a state, "7:4,0:0", the words of a memory one behind the
#                      other; and the nets that carry its value, from their bit LOW up
#   output NAME        an output
#   reset NAME         an input that resets some of them asynchronously, "low NAME" where it is low
#   inner NAME         a register that does, likewise
#   loop NAME          a net that may be in a combinational loop
#   clock NAME         a clock, "falling NAME" where registers change on that edge
#   clocked REGISTER NAME
#                      where there are several clocks, one that it changes on
#   synchronous NAME   of a clock of which none is asynchronous, the input that gives most of its
#                      registers a constant at the clock, "low NAME" likewise: RESET, or one that is
#                      called so
#   given RESET NAME HEX
#                      where there are several resets, the constant that one gives a register
#   value NAME HEX     the constant that all resets together, or where there is none an initial block,
#                      give a register; no line of one that has none
#
# CLOCK is the name of an input; "-" where there is to be no register at all; "?" where the clocks are
# to be found: then there is no line clock where there is no register. One without a comma has registers
# on its rising edge alone.
#
# A bit holds a state where a clock writes it with <=, or with = and it is read before that on some
# way through the process, or elsewhere. A loop is taken to write all that it writes at an index that
# changes; yosys, where it reads the RTL, tells where that is not so.
#
# What a design cannot have, a clock that is no input, both edges of one, a latch, a bidirectional port,
# ends it with status 1 and one line, which names the net.
use strict;
use warnings;
use FindBin;
require "$FindBin::Bin/rtl_tree.pl";
require "$FindBin::Bin/rtl_process.pl";
require "$FindBin::Bin/rtl_clock.pl";
require "$FindBin::Bin/rtl_reset.pl";

our (%modules, @packages, $top, %info, %in_package, %alias, %exposed);
my (undef, $warnings_file, $pins, $netlist_file) = @ARGV;
my ($clock_list, $wanted_reset) = split /:/, $pins;
my @clocks = split /,/, $clock_list;
my $is_one = $clock_list !~ /,/;

my %carries;     # net => [net that has its value, from which of its bits on]..., by paths
my %inverts;     # net => nets that have its inverse
my @processes;   # clocked: edges, what it writes
my @initial;

sub carry {
    my ($from, $to, $low) = @_;
    push @{$carries{$from}}, [$to, $low];
}
# Where the value is the inverse of one net.
sub invert {
    my ($value, $to, $scope) = @_;
    my ($of) = $value->{tag} eq 'not' ? @{$value->{in}} : ();
    my $from = $of && $of->{tag} =~ /^varx?ref$/ && net_of($of, $scope);
    push @{$inverts{$from}}, $to if $from;
}
sub expose {
    my ($net) = @_;
    $exposed{$net} = bits(0, $info{$net}{bits}) if $info{$net};
}

# What is in one instance of a module.
sub walk {
    my ($node, $path, $around) = @_;
    my $scope = scope_in($node, $path, $around);
    for my $in (@{$node->{in}}) {
        my ($tag, $name) = ($in->{tag}, $in->{has}{name});
        if ($tag eq 'begin') {
            walk($in, $path . (defined $name ? "$name." : ''), $scope);
        } elsif ($tag eq 'instance') {
            my $module = $modules{$in->{has}{defName}} or next;
            my $below = "$path$name.";
            connect_port($_, $below . port_name($_, $module), $scope) for grep { @{$_->{in}} } @{$in->{in}};
            walk($module, $below, {});
        } elsif ($tag eq 'contassign') {
            my ($value, $target) = @{$in->{in}};
            follow($value, $scope, {is_wire => scalar($value->{tag} =~ /^varx?ref$/)});
            next if $target->{tag} !~ /^varx?ref$/;
            my $to = net_of($target, $scope) // next;
            invert($value, $to, $scope);
            my @parts = $value;
            @parts = map { $_->{tag} eq 'concat' ? @{$_->{in}} : $_ } @parts
              while grep { $_->{tag} eq 'concat' } @parts;
            my $low = 0;
            for my $part (reverse @parts) {
                my $from = $part->{tag} =~ /^varx?ref$/ ? net_of($part, $scope) : undef;
                carry($from, $to, $low) if defined $from;
                $low += size_of($part->{has}{dtype_id});
            }
        } elsif ($tag =~ /^(?:always|initial)/) {
            my %process = (written => {}, sure => {}, jumps => []);
            my @edges = grep { ($_->{has}{edgeType} // '') =~ /^(?:POS|NEG|BOTH)/ } all_of($in, 'senitem');
            push @initial, {body => $in, scope => $scope} if !@edges && $tag =~ /^initial/;
            next if !@edges && $tag =~ /^initial/;
            follow($_, $scope, \%process) for @{$in->{in}};
            next if !@edges;
            $process{edges} = [map { edge($_, $scope) } @edges];
            $process{tested} = [map { nets_of($_, $scope) } tested($in)];
            $process{body} = $in;
            $process{scope} = $scope;
            push @processes, \%process;
        }
    }
    return;
}
sub edge {
    my ($item, $scope) = @_;
    return map { [$item->{has}{edgeType}, net_of($_->[0], $scope) // $_->[0]{has}{name}] }
      grep { $_->[0]{tag} =~ /^varx?ref$/ } map { places($_, []) } @{$item->{in}};
}
# What a process reads or writes, beside its edges.
sub tested {
    my @body = grep { $_->{tag} ne 'sentree' } @{$_[0]{in}};
    return grep { $_->{tag} =~ /^varx?ref$/ } map { $_, all_of($_, 'varref'), all_of($_, 'varxref') } @body;
}
# The name of a port, that may be given by its place.
sub port_name {
    my ($port, $module) = @_;
    return $port->{has}{name} if $port->{has}{name} !~ /^__pinNumber(\d+)$/;
    my $place = $1;
    my @vars = grep { $_->{tag} eq 'var' } @{$module->{in}};
    my %by_place = map { $_->{has}{pinIndex} => $_ } grep { $_->{has}{pinIndex} } @vars;
    # Of an interface the place is not told: it has the next that is free.
    my $next = 1;
    for my $var (grep { ($_->{has}{vartype} // '') eq 'ifaceref' } @vars) {
        next if $var->{has}{name} =~ /__Viftop$/;
        ++$next while $by_place{$next};
        $by_place{$next} = $var;
    }
    return $by_place{$place} ? $by_place{$place}{has}{name} : '';
}
sub connect_port {
    my ($port, $inner, $scope) = @_;
    my ($value) = @{$port->{in}};
    my $is_net = $value->{tag} =~ /^varx?ref$/;
    my $way = $port->{has}{direction};
    if (!defined $way) {  # an interface
        $alias{$inner} = $scope->{path} . ($value->{has}{name} // '') =~ s/__Viftop$//r;
        return;
    }
    my $net = $is_net ? net_of($value, $scope) : undef;
    if ($way ne 'out') {
        follow($value, $scope, {is_wire => $is_net});
        carry($net, $inner, 0) if defined $net;
        invert($value, $inner, $scope);
    } else {
        expose($inner);
        carry($inner, $net, 0) if defined $net;
    }
}

for my $package (@packages) {
    my $path = $package->{has}{name} . '.';
    declare($package, $path);
    my $scope = scope_in($package, $path, {});
    $in_package{$_} = $scope->{tasks}{$_} for keys %{$scope->{tasks}};
}
declare($top, '');
walk($top, '', {});

our (%inputs, %outputs);
for my $port (grep { $_->{tag} eq 'var' && $_->{has}{dir} } @{$top->{in}}) {
    my ($name, $way) = @{$port->{has}}{qw(name dir)};
    refuse("$name: a port of both directions") if $way eq 'inout';
    $inputs{$name} = 1 if $way eq 'input';
    $outputs{$name} = 1 if $way eq 'output';
    expose($name);
}
for my $clock (grep { !/^[-?]$/ && !$inputs{$_} } @clocks) {
    refuse("$clock: the RTL has no such input, but it is named as its clock");
}

# All nets that carry the value of one: from which of its bits on.
sub carriers {
    my @left = [$_[0], 0];
    my %seen;
    while (my $next = shift @left) {
        my ($net, $low) = @$next;
        next if exists $seen{$net};
        $seen{$net} = $low;
        push @left, map { [$_->[0], $low + $_->[1]] } @{$carries{$net} // []};
    }
    return \%seen;
}
# All nets that carry the value of an input, "0 NET", or its inverse, "1 NET".
sub reached {
    my @left = ([$_[0], 0]);
    my %seen;
    while (my $next = shift @left) {
        my ($net, $odd) = @$next;
        next if $seen{"$odd $net"}++;
        push @left, map { [$_->[0], $odd] } @{$carries{$net} // []};
        push @left, map { [$_, 1 - $odd] } @{$inverts{$net} // []};
    }
    return \%seen;
}
our %reached = map { $_ => reached($_) } keys %inputs;
# The input that a net is, or its inverse is; '' where it is made of something else.
sub input_of {
    my ($net, $odd) = @_;
    my ($input) = grep { $reached{$_}{"$odd $net"} } sort keys %inputs;
    return $input // '';
}

my (%registers, %resets, @by_others);
sub held_by {
    my ($p) = @_;
    my %held;
    for my $net (grep { $info{$_} } keys %{$p->{written}}) {
        my $bits = $p->{written}{$net};
        my $read = carries_to_output($net) ? $bits : $exposed{$net} // '';
        my $state = ($bits & $read) | ($p->{later}{$net} // '');
        $held{$net} = $state if $state =~ /[^\0]/;
    }
    return \%held;
}
for my $p (@processes) { $p->{held} = held_by($p) }
@processes = grep { %{$_->{held}} } @processes;
@clocks = $pins =~ /^\?/ ? found_clocks(@processes) : $pins =~ /^-/ ? () : @clocks;
refuse(one_held($processes[0]) . ': a register, but the design is declared COMBINATIONAL')
  if @processes && !@clocks;
my $way_of = give_clocks(\@clocks, $pins !~ /^\?/ && $is_one, @processes);
require_plain($_) for @clocks > 1 || !$is_one ? @clocks : ();
for my $p (@processes) {
    my %held = %{$p->{held}};
    my $named = one_held($p);
    my @others = @{$p->{others}};
    my ($other) = @others;
    refuse("$named: an asynchronous set and reset, $others[0][1] and $others[1][1]") if @others > 1;
    if ($other) {
        my ($way, $net) = @$other;
        my ($input, $inverse) = map { input_of($net, $_) } 0, 1;
        my $is_low = ($way eq 'NEG' xor $input eq '');
        $resets{($is_low ? 'low ' : '') . ($input || $inverse)} = 1 if "$input$inverse" ne '';
        $p->{is_inner} = "$input$inverse" eq '';
        push @by_others, [$named, $way, $net] if $p->{is_inner};
    }
    # Verilator keeps what an assertion samples in such a variable.
    $registers{$_} = ($registers{$_} // '') | $held{$_} for grep { !/(^|\.)_Vpast_\d+_\d+$/ } keys %held;
}
# A register of one bit may reset others, itself or inverted.
my %inner;
for my $by (@by_others) {
    my ($named, $way, $net) = @$by;
    my ($of, $odd);
    for my $candidate (grep { $info{$_}{bits} == 1 } sort keys %registers) {
        my $nets = reached($candidate);
        ($of, $odd) = ($candidate, $nets->{"1 $net"} ? 1 : 0) if $nets->{"0 $net"} || $nets->{"1 $net"};
    }
    refuse("$named: an asynchronous reset by $net, which is no input") if !defined $of;
    $reached{$of} = reached($of);
    $inner{(($way eq 'NEG' xor $odd) ? 'low ' : '') . $of} = 1;
}

sub carries_to_output {
    my ($net) = @_;
    return scalar grep { $_ ne $net && $exposed{$_} } keys %{carriers($net)};
}

my $warnings = text_of($warnings_file);
my $top_name = $top->{has}{name};
sub below_top { return $_[0] =~ s/^\Q$top_name\E\.//r =~ s/__DOT__/./gr }
my @latches = map { below_top($_) } $warnings =~ /^%Warning-LATCH: .*Latch inferred for signal '([^']+)'/mg;
# The variable of a loop, which is always written before it is read, holds nothing.
@latches = grep { !$info{$_} || ($exposed{$_} // '') =~ /[^\0]/ || carries_to_output($_) } @latches;

# What yosys found besides.
sub hold {
    my ($net, $low, $count) = @_;
    $registers{$net} = ($registers{$net} // '') | bits($low, $count);
}
# The net of the tree and its bit that a name of yosys is.
sub place_of {
    my ($name, $bit, $width) = $_[0] =~ /^(.*):(\d+):(\d+)$/;
    return [$name, $bit] if $info{$name} && $info{$name}{bits} == $width;
    return if $name !~ /^(.*)\[(\d+)\]$/ || !$info{$1} || $info{$1}{words} <= 0 || $info{$1}{width} != $width;
    return [$1, ($2 - $info{$1}{first}) * $width + $bit];
}
for my $line (defined $netlist_file ? split /\n/, text_of($netlist_file) : ()) {
    my ($what, @names) = split / /, $line;
    if ($what eq 'memory') {
        hold($names[0], 0, $info{$names[0]}{bits}) if $info{$names[0]} && !$registers{$names[0]};
        next;
    }
    my @places = grep { $_ } map { place_of($_) } @names;
    my $name = $places[0] ? $places[0][0] : $names[0] =~ s/:\d+:\d+$//r;
    push @latches, $name if $what eq 'latch';
    next if $what eq 'latch' || grep { vec($registers{$_->[0]} // '', $_->[1], 1) } @places;
    if (!@places) {
        my ($bit, $width) = $names[0] =~ /:(\d+):(\d+)$/;
        $info{$name} //= {width => $width, words => 0, bits => $width, first => 0};
        @places = [$name, $bit];
    }
    hold(@{$places[0]}, 1);
}
refuse((sort @latches)[0] . ': a latch') if @latches;


sub ranges {
    my $text = unpack 'b*', $_[0];
    my @ranges;
    unshift @ranges, ($+[0] - 1) . ":$-[0]" while $text =~ /1+/g;
    return join ',', @ranges;
}
sub shape_text { return "$info{$_[0]}{width} $info{$_[0]}{words}" }
for my $register (sort keys %registers) {
    my $carriers = carriers($register);
    my @nets = map { "$_ " . shape_text($_) . " $carriers->{$_}" }
      grep { $_ ne $register && $info{$_} } sort keys %$carriers;
    print join(' ', 'register', $register, shape_text($register), ranges($registers{$register}), @nets), "\n";
}
print "output $_->{has}{name}\n" for grep { ($_->{has}{dir} // '') eq 'output' } @{$top->{in}};
print "reset $_\n" for sort keys %resets;
print "inner $_\n" for sort keys %inner;
my %is_falling = map { $_ => ($way_of->{$_} // 'POS') ne 'POS' } @clocks;
print 'clock ', $is_falling{$_} ? 'falling ' : '', "$_\n" for @clocks;
if (@clocks > 1) {
    for my $p (@processes) { print "clocked $_ $p->{clock}\n" for sort keys %{$p->{held}} }
}

tell_resets($wanted_reset, [keys %resets], [keys %inner], [sort keys %registers], \@processes, \@initial);
print "loop ", below_top($_), "\n"
  for $warnings =~ /^%Warning-UNOPTFLAT: [^']*'([^']+)'/mg;
