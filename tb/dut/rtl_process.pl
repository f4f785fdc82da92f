# What a process of RTL reads and writes, in the order of its statements.
use strict;
use warnings;

our (%info, %in_package);
our %exposed;     # net => bits that are read before they are written, somewhere
our %valued;      # nets that something is worked out from, and that are not only carried on

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
    $valued{$net} = 1 if !$p->{is_wire};
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

1;
