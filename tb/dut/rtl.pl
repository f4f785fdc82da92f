#!/usr/bin/env perl
# rtl.pl TREE.xml WARNINGS CLOCK [NETLIST]
#
# Reads the tree of a design that `verilator --xml-only` wrote and what `verilator --lint-only` said of
# it, and what rtl_yosys.pl found. On standard output, a line each:
#
#   register NAME WIDTH WORDS BITS [NET WIDTH WORDS LOW]...
#                      a register, by its path below the top, its bits, those of a word of a memory,
#                      and its words, 0 where it is no memory, -1 where no table can have it; those of
#                      its bits that hold a state, "7:4,0:0", the words of a memory one behind the
#                      other; and the nets that carry its value, from their bit LOW up
#   reset NAME         an input that resets some of them asynchronously, "low NAME" where it is low
#   loop NAME          a net that may be in a combinational loop
#
# A bit holds a state where a clock writes it with <=, or with = and it is read before that on some
# way through the process, or elsewhere. A loop is taken to write all that it writes at an index that
# changes; yosys, where it reads the RTL, tells where that is not so.
#
# What a design cannot have, a second clock, a falling edge, a latch, a bidirectional port, ends it
# with status 1 and one line, which names the net.
use strict;
use warnings;

my ($tree_file, $warnings_file, $clock, $netlist_file) = @ARGV;

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

my %modules = map { $_->{has}{name} => $_ } map { all_of($root, $_) } qw(module iface);
my @packages = all_of($root, 'package');
my ($top) = grep { $_->{has}{topModule} } values %modules;
refuse('Verilator names no top module') if !$top;

# Types, by their numbers.
my %types = map { $_->{has}{id} => $_ } map { @{$_->{in}} } all_of($root, 'typetable');
sub type_of {
    my $type = $types{$_[0] // ''} // {tag => '', has => {}, in => []};
    return $type if $type->{tag} !~ /^(?:ref|const|enum|member)dtype$/ || !$type->{has}{sub_dtype_id};
    return type_of($type->{has}{sub_dtype_id});
}
# The number of a node, undef where it is no constant.
sub constant {
    my ($node) = @_;
    return if !$node || $node->{tag} ne 'const' || $node->{has}{name} !~ /&apos;s?h([0-9a-f]{1,8})$/;
    my $value = hex $1;
    return $value >= 2**31 && $node->{has}{name} =~ /^32&apos;s/ ? $value - 2**32 : $value;
}
sub elements {
    my ($range) = grep { $_->{tag} eq 'range' } @{$_[0]{in}};
    my ($left, $right) = map { constant($_) } @{$range->{in}};
    return defined $right ? abs($left - $right) + 1 : 1;
}
sub first_of {
    my ($range) = grep { $_->{tag} eq 'range' } @{$_[0]{in}};
    return (sort { $a <=> $b } map { constant($_) // 0 } @{$range->{in}})[0] // 0;
}
# All bits of a type.
sub size_of {
    my $type = type_of($_[0]);
    my $has = $type->{has};
    return abs($has->{left} - $has->{right}) + 1 if defined $has->{left};
    return elements($type) * size_of($has->{sub_dtype_id}) if $type->{tag} =~ /^(?:un)?packarray/;
    my @members = map { size_of($_->{has}{sub_dtype_id} // $_->{has}{id}) } @{$type->{in} // []};
    return (sort { $a <=> $b } @members)[-1] // 1 if $type->{tag} eq 'uniondtype';
    my $sum = 0;
    $sum += $_ for @members;
    return $sum || (($has->{name} // '') eq 'double' ? 64 : 1);
}
# The width of a net or of a word of a memory, and its words; a memory of several dimensions is an array
# of arrays, be they packed or not.
sub shape_of {
    my $type = type_of($_[0]);
    return (size_of($_[0]), 0) if $type->{tag} =~ /^(?:basic|packarray|struct|union)/;
    my $word = $type->{has}{sub_dtype_id};
    return (size_of($_[0]), -1) if $type->{tag} ne 'unpackarraydtype' || type_of($word)->{tag} =~ /array/;
    return (size_of($word), elements($type));
}

# Bits of a net, as a string of them.
sub bits { return pack 'b*', '0' x $_[0] . '1' x $_[1] }
sub without { return $_[0] ^ ($_[0] & $_[1]) }

my %info;        # net => its width, words and all its bits
my %by_name;     # name => all nets of that name
my %packaged;    # name => variables of packages
my %in_package;  # name => tasks of packages
my %alias;       # a port that is an interface => the interface
my %carries;     # net => [net that has its value, from which of its bits on]..., by paths
my %inverts;     # net => nets that have its inverse
my @processes;   # clocked: edges, what it writes
my %exposed;     # net => bits that are read before they are written, somewhere

sub declare {
    my ($node, $path) = @_;
    for my $in (@{$node->{in}}) {
        my ($tag, $name) = ($in->{tag}, $in->{has}{name});
        if ($tag eq 'var') {
            next if $in->{has}{param} || $in->{has}{localparam};
            my ($width, $words) = shape_of($in->{has}{dtype_id});
            my $net = $path . $name;
            $info{$net} = {width => $width, words => $words, bits => $width * ($words > 0 ? $words : 1),
                first => $words > 0 ? first_of(type_of($in->{has}{dtype_id})) : 0};
            push @{$by_name{$name}}, $net;
            push @{$packaged{$name}}, $net if $node->{tag} eq 'package';
        } elsif ($tag eq 'instance') {
            declare($modules{$in->{has}{defName}}, "$path$name.") if $modules{$in->{has}{defName}};
        } else {
            my $named = $tag =~ /^(?:begin|task|func)$/ && defined $name;
            declare($in, $path . ($named ? "$name." : ''));
        }
    }
    return;
}

# What the names in a scope are: nets by their paths, tasks with their scopes.
sub scope_in {
    my ($node, $path, $around) = @_;
    my $scope = {path => $path, nets => {%{$around->{nets} // {}}}, tasks => {%{$around->{tasks} // {}}}};
    for my $in (@{$node->{in}}) {
        my ($tag, $name) = ($in->{tag}, $in->{has}{name});
        $scope->{nets}{$name} = $path . $name if $tag eq 'var' && $info{$path . $name};
        $scope->{tasks}{$name} = [$in, $scope] if $tag =~ /^(?:task|func)$/;
    }
    return $scope;
}
# The nets that a reference may be: one, unless its name alone tells.
sub nets_of {
    my ($node, $scope) = @_;
    my ($name, $dotted) = ($node->{has}{name}, $node->{has}{dotted} // '');
    return grep { defined } $scope->{nets}{$name}, @{$packaged{$name} // []} if $dotted eq '';
    for (my $path = $scope->{path}; ; $path =~ s/[^.]*\.$// or last) {
        my $in = $path . $dotted;
        $in = $alias{$in} while $alias{$in};
        return "$in.$name" if $info{"$in.$name"};
        last if $path eq '';
    }
    return @{$by_name{$name} // []};
}
sub net_of { return (nets_of(@_))[0] }

# The parts of nets that an expression is, [reference, low, bits, whether they are just these]; the
# others that it has are put into the list.
sub places {
    my ($node, $others) = @_;
    my ($tag, @in) = ($node->{tag}, @{$node->{in}});
    return [$node, 0, size_of($node->{has}{dtype_id}), 1] if $tag =~ /^varx?ref$/;
    return map { places($_, $others) } @in if $tag =~ /^concat/;
    my ($from, @at) = @in;
    return if !$from;
    push @$others, @at;
    my @from = places($from, $others);
    for my $place (@from) {
        my $is_one = $tag =~ /^(?:sel|arraysel)$/ && @from == 1 && $place->[3];
        my $low = constant($at[0]);
        my $bits = $tag eq 'sel' ? constant($at[1]) : size_of($node->{has}{dtype_id});
        if ($is_one && defined $low && defined $bits) {
            $place->[1] += $low * ($tag eq 'sel' ? 1 : $bits);
            $place->[2] = $bits;
        } else {
            $place->[3] = 0;
        }
    }
    return @from;
}

# What is written on each of some ways through a process. A way that has been left writes anything.
sub meet {
    my @ways = grep { !$_->{left} } @_;
    my ($first, @more) = @ways ? @ways : {left => 1};
    my %all = %$first;
    for my $way (@more) {
        $all{$_} &= $way->{$_} // '' for keys %all;
    }
    return \%all;
}

sub read_net {
    my ($net, $bits, $p) = @_;
    return if $p->{sure}{left};
    my $open = without($bits, $p->{sure}{$net} // '');
    $exposed{$net} = ($exposed{$net} // '') | $open;
    return;
}
sub write_place {
    my ($place, $delayed, $scope, $p) = @_;
    my ($node, $low, $count, $exact) = @$place;
    my @nets = nets_of($node, $scope);
    for my $net (@nets) {
        my $bits = bits($low, $count);
        $p->{written}{$net} = ($p->{written}{$net} // '') | $bits;
        if ($delayed) {
            $p->{later}{$net} = ($p->{later}{$net} // '') | $bits;
        } elsif (@nets == 1 && ($exact || $p->{loops})) {
            $p->{sure}{$net} = ($p->{sure}{$net} // '') | $bits;
        }
    }
    return;
}

# Reads and writes of a process in their order; a task is what is in it.
sub follow {
    my ($node, $scope, $p) = @_;
    my ($tag, @in) = ($node->{tag}, @{$node->{in}});
    return if $tag =~ /^(?:sentree|var)$/;
    if ($tag =~ /^assign/ && @in > 1) {
        my ($value, $target, @more) = @in;
        my @others;
        my @to = places($target, \@others);
        follow($_, $scope, $p) for $value, @more, @others;
        write_place($_, $tag eq 'assigndly', $scope, $p) for @to;
    } elsif ($tag =~ /^(?:varx?ref|sel|arraysel)$/) {
        my @others;
        my @from = is_part($node) ? places($node, \@others) : ();
        @others = @in if !@from;
        follow($_, $scope, $p) for @others;
        for my $place (@from) {
            read_net($_, bits(@$place[1, 2]), $p) for nets_of($place->[0], $scope);
        }
    } elsif ($tag =~ /^(?:if|case)$/) {
        my ($value, @ways) = @in;
        follow($value, $scope, $p);
        my $before = $p->{sure};
        my $is_full = $tag eq 'if' ? @ways > 1 : is_full($value, @ways);
        my @after = $is_full ? () : $before;
        for my $way (@ways) {
            $p->{sure} = {%$before};
            follow($way, $scope, $p);
            push @after, $p->{sure};
        }
        $p->{sure} = meet(@after);
    } elsif ($tag eq 'while') {
        ++$p->{loops};
        follow($_, $scope, $p) for @in;
        --$p->{loops};
    } elsif ($tag eq 'jumpblock') {
        my $outer = $p->{jumps};
        $p->{jumps} = [];
        follow($_, $scope, $p) for @in;
        push @$outer, @{$p->{jumps}};  # which block it leaves is not told
        $p->{sure} = meet($p->{sure}, @{$p->{jumps}});
        $p->{jumps} = $outer;
    } elsif ($tag eq 'jumpgo') {
        push @{$p->{jumps}}, $p->{sure};
        $p->{sure} = {left => 1};
    } elsif ($tag =~ /^(?:task|func)ref$/) {
        call($node, $scope, $p);
    } elsif ($tag eq 'begin') {
        my $name = $node->{has}{name};
        my $inner = defined $name ? scope_in($node, "$scope->{path}$name.", $scope) : $scope;
        follow($_, $inner, $p) for @in;
    } else {
        follow($_, $scope, $p) for @in;
    }
    return;
}
# Whether it is some bits of a net, and of nothing else.
sub is_part {
    my ($node) = @_;
    return 1 if $node->{tag} =~ /^varx?ref$/;
    return $node->{tag} =~ /^(?:sel|arraysel|structsel)$/ && is_part($node->{in}[0]);
}
# Whether the ways of a case are all that there are.
sub is_full {
    my ($value, @items) = @_;
    $value = $value->{in}[0] while $value->{tag} eq 'extend';
    my $is_statement = qr/^(?:begin|assign\w*|if|case|while|jump\w+|taskref|display|stop|finish)$/;
    my %values;
    for my $item (@items) {
        my @in = @{$item->{in}};
        return 1 if !@in || $in[0]{tag} =~ $is_statement;  # the default
        $values{constant($_) // ''} = 1 for grep { $_->{tag} eq 'const' } @in;
    }
    delete $values{''};
    return keys %values == 2**size_of($value->{has}{dtype_id});
}
# The arguments are read and given, what is in it follows, and what it gives is written.
sub call {
    my ($node, $scope, $p) = @_;
    my $name = $node->{has}{name};
    my ($task, $home) = @{$scope->{tasks}{$name} // $in_package{$name} // []};
    my @ports = grep { $_->{tag} eq 'var' && $_->{has}{dir} } $task ? @{$task->{in}} : ();
    shift @ports if $task && $task->{tag} eq 'func';
    my $inner = $task && scope_in($task, "$home->{path}$name.", $home);
    my @given;
    for my $arg (map { $_->{tag} eq 'arg' ? @{$_->{in}} : () } @{$node->{in}}) {
        my $port = shift @ports;
        my $way = $port ? $port->{has}{dir} : 'inout';
        follow($arg, $scope, $p) if $way ne 'output';
        push @given, $arg if $way ne 'input';
        write_place([$port, 0, size_of($port->{has}{dtype_id}), 1], 0, $inner, $p) if $way eq 'input';
    }
    if ($task && !$p->{in}{$name}) {
        local $p->{in}{$name} = 1;
        follow($_, $inner, $p) for @{$task->{in}};
    }
    for my $arg (@given) {
        write_place($_, 0, $scope, $p) for grep { $_->[0]{tag} =~ /^varx?ref$/ } places($arg, []);
    }
    return;
}

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
            follow($value, $scope, {});
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
            next if !@edges && $tag =~ /^initial/;
            follow($_, $scope, \%process) for @{$in->{in}};
            next if !@edges;
            $process{edges} = [map { edge($_, $scope) } @edges];
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
        follow($value, $scope, {});
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

my %inputs;
for my $port (grep { $_->{tag} eq 'var' && $_->{has}{dir} } @{$top->{in}}) {
    my ($name, $way) = @{$port->{has}}{qw(name dir)};
    refuse("$name: a port of both directions") if $way eq 'inout';
    $inputs{$name} = 1 if $way eq 'input';
    expose($name);
}
refuse("$clock: the RTL has no such input, which is to be its clock") if !$inputs{$clock};

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
my %reached = map { $_ => reached($_) } keys %inputs;
# The input that a net is, or its inverse is; '' where it is made of something else.
sub input_of {
    my ($net, $odd) = @_;
    my ($input) = grep { $reached{$_}{"$odd $net"} } sort keys %inputs;
    return $input // '';
}

my (%registers, %resets);
for my $p (@processes) {
    my %held;
    for my $net (grep { $info{$_} } keys %{$p->{written}}) {
        my $bits = $p->{written}{$net};
        my $read = carries_to_output($net) ? $bits : $exposed{$net} // '';
        my $state = ($bits & $read) | ($p->{later}{$net} // '');
        $held{$net} = $state if $state =~ /[^\0]/;
    }
    my $named = (sort keys %held)[0] // next;
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
    $registers{$_} = ($registers{$_} // '') | $held{$_} for keys %held;
}

sub carries_to_output {
    my ($net) = @_;
    return scalar grep { $_ ne $net && $exposed{$_} } keys %{carriers($net)};
}

my $warnings = text_of($warnings_file);
my $top_name = $top->{has}{name};
sub below_top { return $_[0] =~ s/^\Q$top_name\E\.//r =~ s/__DOT__/./gr }
my @latches = map { below_top($_) } $warnings =~ /^%Warning-LATCH: .*Latch inferred for signal '([^']+)'/mg;

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
print "reset $_\n" for sort keys %resets;
print "loop ", below_top($_), "\n"
  for $warnings =~ /^%Warning-UNOPTFLAT: [^']*'([^']+)'/mg;
