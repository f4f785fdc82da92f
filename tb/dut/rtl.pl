#!/usr/bin/env perl
# rtl.pl TREE.xml WARNINGS CLOCK
#
# Reads the tree of a design that `verilator --xml-only` wrote and what `verilator --lint-only` said of
# it. On standard output, a line each:
#
#   register NAME...   a register, by its path below the top, and the nets that carry its value;
#                      NAME[][] is a memory of several dimensions
#   reset NAME         an input that resets some of them asynchronously, "low NAME" where it is low
#   loop NAME          a net that may be in a combinational loop
#
# What a design cannot have, a second clock, a falling edge, a latch, a bidirectional port, ends it
# with status 1 and one line, which names the net.
use strict;
use warnings;

my ($tree_file, $warnings_file, $clock) = @ARGV;

sub text_of {
    my ($name) = @_;
    open my $file, '<', $name or die "$name: $!\n";
    local $/;
    my $text = <$file>;
    return $text;
}

sub refuse {
    print STDERR "$_[0]\n";
    exit 1;
}

# The tree: a node has its tag, its attributes and the nodes in it.
my $root = {tag => '', in => []};
{
    my @open = ($root);
    my $text = text_of($tree_file);
    while ($text =~ m{<(/?)(\w+)((?:\s+[\w:]+="[^"]*")*)\s*(/?)>}g) {
        my ($end, $tag, $attributes, $empty) = ($1, $2, $3, $4);
        if ($end) { pop @open; next }
        my %has = $attributes =~ /([\w:]+)="([^"]*)"/g;
        my $node = {tag => $tag, has => \%has, in => []};
        push @{$open[-1]{in}}, $node;
        push @open, $node if !$empty;
    }
}

sub all_of {
    my ($node, $tag) = @_;
    return map { ($_->{tag} eq $tag ? $_ : (), all_of($_, $tag)) } @{$node->{in}};
}

my %files = map { $_->{has}{id} => $_->{has}{filename} } all_of($root, 'file');
my %modules = map { $_->{has}{name} => $_ } all_of($root, 'module');
my ($top) = grep { $_->{has}{topModule} } values %modules;
refuse('Verilator names no top module') if !$top;

# The types by their numbers; that of a memory is an array of words, one of several dimensions an array
# of arrays, be they packed or not.
my %types = map { $_->{has}{id} => $_ } map { @{$_->{in}} } all_of($root, 'typetable');
sub type_of {
    my $type = $types{$_[0] // ''} // {tag => '', has => {}};
    return $type->{tag} eq 'refdtype' ? type_of($type->{has}{sub_dtype_id}) : $type;
}
sub is_deep {
    my $type = type_of($_[0]->{has}{dtype_id});
    return $type->{tag} eq 'unpackarraydtype' && type_of($type->{has}{sub_dtype_id})->{tag} =~ /array/;
}

# The nets that an expression on the left of an assignment is: of a part of a net the net.
sub targets {
    my ($node) = @_;
    return ($node->{has}{name}) if $node->{tag} eq 'varref';
    my @in = @{$node->{in}};
    return map { targets($_) } $node->{tag} =~ /^concat/ ? @in : @in[0 .. ($#in < 0 ? -1 : 0)];
}

my %carries;     # net => nets that have its value, by paths
my %inverts;     # net => nets that have its inverse
my @processes;   # clocked: path, scope, edges, what it writes
my %exposed;     # nets that are read before they are written, somewhere
my @latches;
my %deep;        # memories of several dimensions

sub carry {
    my ($from, $to) = @_;
    push @{$carries{$from}}, $to;
}
# Where the value is the inverse of one net.
sub invert {
    my ($value, $to, $resolve) = @_;
    my ($of) = $value->{tag} eq 'not' ? @{$value->{in}} : ();
    my $from = $of && $of->{tag} eq 'varref' && $resolve->($of->{has}{name});
    push @{$inverts{$from}}, $to if $from;
}

# Reads and writes of a process in their order; a task is what is in it.
sub read_process {
    my ($node, $resolve, $p, $tasks) = @_;
    my $tag = $node->{tag};
    return if $tag eq 'sentree' || $tag eq 'var';
    if ($tag eq 'begin') {
        my %own = map { $_->{has}{name} => 1 } grep { $_->{tag} eq 'var' } @{$node->{in}};
        my $outer = $resolve;
        $resolve = sub { $own{$_[0]} ? undef : $outer->($_[0]) } if %own;
    }
    if ($tag =~ /^assign/ && @{$node->{in}} > 1) {
        my ($value, $target, @more) = @{$node->{in}};
        read_process($_, $resolve, $p, $tasks) for $value, @more;
        # An index on the left is read, and so are no others of its nets.
        my %written = map { $_ => 1 } targets($target);
        read_process($_, $resolve, $p, $tasks)
          for grep { !$written{$_->{has}{name}} } all_of($target, 'varref');
        for my $name (keys %written) {
            my $net = $resolve->($name) // next;
            $p->{written}{$net} //= 1;
            $p->{later}{$net} = 1 if $tag eq 'assigndly';
        }
        return;
    }
    if ($tag eq 'varref') {
        my $net = $resolve->($node->{has}{name}) // return;
        $exposed{$net} = 1 if !$p->{written}{$net} || $p->{later}{$net};
        return;
    }
    my $task = $tag =~ /^(?:task|func)ref$/ && $tasks->{$node->{has}{name}};
    if ($task && !$p->{in}{$node->{has}{name}}++) {
        my %own = map { $_->{has}{name} => 1 } all_of($task, 'var');
        read_process($_, sub { $own{$_[0]} ? undef : $resolve->($_[0]) }, $p, $tasks)
          for @{$task->{in}};
    }
    read_process($_, $resolve, $p, $tasks) for @{$node->{in}};
    return;
}

# What is in one instance of a module. `nets` are those of the scopes around, by name.
sub walk {
    my ($node, $path, $around, $tasks) = @_;
    my %nets = %$around;
    my %here = %$tasks;
    for my $in (@{$node->{in}}) {
        $nets{$in->{has}{name}} = $path . $in->{has}{name} if $in->{tag} eq 'var';
        $deep{$path . $in->{has}{name}} = '[][]' if $in->{tag} eq 'var' && is_deep($in);
        $here{$in->{has}{name}} = $in if $in->{tag} =~ /^(?:task|func)$/;
    }
    my $resolve = sub { $nets{$_[0]} };
    for my $in (@{$node->{in}}) {
        my ($tag, $name) = ($in->{tag}, $in->{has}{name});
        if ($tag eq 'begin') {
            walk($in, $path . (defined $name ? "$name." : ''), \%nets, \%here);
        } elsif ($tag eq 'instance') {
            my $module = $modules{$in->{has}{defName}} or next;
            my $below = "$path$name.";
            for my $port (@{$in->{in}}) {
                my ($value) = @{$port->{in}} or next;
                my $inner = $below . $port->{has}{name};
                my ($net) = $value->{tag} eq 'varref' ? $resolve->($value->{has}{name}) : ();
                if ($port->{has}{direction} ne 'out') {
                    read_process($value, $resolve, {}, \%here);
                    carry($net, $inner) if defined $net;
                    invert($value, $inner, $resolve);
                } elsif (defined $net) {
                    carry($inner, $net);
                }
            }
            walk($module, $below, {}, {});
        } elsif ($tag eq 'contassign') {
            my ($value, $target) = @{$in->{in}};
            read_process($value, $resolve, {}, \%here);
            next if $target->{tag} ne 'varref';
            my $to = $resolve->($target->{has}{name}) // next;
            invert($value, $to, $resolve);
            my @parts = $value;
            @parts = map { $_->{tag} eq 'concat' ? @{$_->{in}} : $_ } @parts
              while grep { $_->{tag} eq 'concat' } @parts;
            next if grep { $_->{tag} ne 'varref' } @parts;
            carry($_, $to) for grep { defined } map { $resolve->($_->{has}{name}) } @parts;
        } elsif ($tag =~ /^always/) {
            my %process;
            my @edges = grep { ($_->{has}{edgeType} // '') =~ /^(?:POS|NEG|BOTH)/ }
              map { @{$_->{in}} } grep { $_->{tag} eq 'sentree' } @{$in->{in}};
            read_process($_, $resolve, \%process, \%here) for @{$in->{in}};
            my ($file, $line, $column) = split /,/, $in->{has}{loc} // '';
            if (!@edges && is_latch($file, $line, $column)) {
                push @latches, keys %{$process{written}};
            }
            push @processes, {%process, edges => [
                map { [$_->{has}{edgeType}, map { $resolve->($_) // $_ } targets($_)] } @edges]}
              if @edges;
        }
    }
    return;
}

# A latch that is meant to be one has no warning.
sub is_latch {
    my ($file, $line, $column) = @_;
    return if !defined $column || !open my $source, '<', $files{$file} // '';
    my @lines = <$source>;
    return substr($lines[$line - 1] // '', $column - 1) =~ /^always_latch\b/;
}

walk($top, '', {}, {});

my %inputs;
for my $port (grep { $_->{tag} eq 'var' && $_->{has}{dir} } @{$top->{in}}) {
    my ($name, $way) = @{$port->{has}}{qw(name dir)};
    refuse("$name: a port of both directions") if $way eq 'inout';
    $inputs{$name} = 1 if $way eq 'input';
    $exposed{$name} = 1;
}
refuse("$clock: the RTL has no such input, which is to be its clock") if !$inputs{$clock};

# All nets that carry the value of one.
sub carriers {
    my @left = @_;
    my %seen;
    while (defined(my $net = shift @left)) {
        push @left, @{$carries{$net} // []} if !$seen{$net}++;
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
        push @left, map { [$_, $odd] } @{$carries{$net} // []};
        push @left, map { [$_, 1 - $odd] } @{$inverts{$net} // []};
    }
    return \%seen;
}
my %reached = map { $_ => reached($_) } keys %inputs;
# The input that a net is, or its inverse is; '' where it is made of something else.
sub input_of {
    my ($net, $odd) = @_;
    my ($input) = grep { $reached{$_}{"$odd $net"} } sort keys %inputs;
    return $input // '';
}

my (%registers, %resets);
for my $p (@processes) {
    my @held = grep { $p->{later}{$_} || $exposed{$_} || carries_to_output($_) }
      sort keys %{$p->{written} // {}};
    my $named = $held[0] // next;
    my @others;
    my $clocks = 0;
    for my $edge (@{$p->{edges}}) {
        my ($way, $net) = @$edge;
        if (input_of($net, 0) eq $clock) {
            refuse("$named: a register on the falling edge of $clock") if $way ne 'POS';
            ++$clocks;
        } else {
            push @others, [$way, $net];
        }
    }
    my ($other) = @others;
    if ($clocks != 1) {
        my ($way, $net) = $other ? @$other : ('', $clock);
        refuse("$named: a register on the falling edge of $net") if $way eq 'NEG' && @others == 1;
        refuse("$named: its clock is $net, and that of the design is $clock");
    }
    refuse("$named: an asynchronous set and reset, $others[0][1] and $others[1][1]") if @others > 1;
    if ($other) {
        my ($way, $net) = @$other;
        my ($input, $inverse) = map { input_of($net, $_) } 0, 1;
        refuse("$named: an asynchronous reset by $net, which is no input") if "$input$inverse" eq '';
        my $is_low = ($way eq 'NEG' xor $input eq '');
        $resets{($is_low ? 'low ' : '') . ($input || $inverse)} = 1;
    }
    $registers{$_} = 1 for @held;
}

sub carries_to_output {
    my ($net) = @_;
    return scalar grep { $exposed{$_} } keys %{carriers($net)};
}

my $warnings = text_of($warnings_file);
my $top_name = $top->{has}{name};
sub below_top { return $_[0] =~ s/^\Q$top_name\E\.//r =~ s/__DOT__/./gr }
push @latches, map { below_top($_) } $warnings =~ /^%Warning-LATCH: .*Latch inferred for signal '([^']+)'/mg;
refuse((sort @latches)[0] . ': a latch') if @latches;

for my $register (sort keys %registers) {
    my $carriers = carriers($register);
    delete $carriers->{$register};
    print join(' ', 'register', $register . ($deep{$register} // ''), sort keys %$carriers), "\n";
}
print "reset $_\n" for sort keys %resets;
print "loop ", below_top($_), "\n"
  for $warnings =~ /^%Warning-UNOPTFLAT: [^']*'([^']+)'/mg;
