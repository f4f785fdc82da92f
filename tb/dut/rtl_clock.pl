# The clocks of RTL: the inputs on whose edges its registers change.
use strict;
use warnings;

our (%info, %inputs, %outputs, %valued);

# The input on whose edges a process's registers change, undef where that is not to be told: of one edge
# that one, and of several the one that it does not read, for a reset it does.
sub likely_clock {
    my ($p) = @_;
    my @nets = map { $_->[1] } @{$p->{edges}};
    my %tested = map { $_ => 1 } @{$p->{tested}};
    my @left = grep { !$tested{$_} } @nets;
    @left = @nets if @left != 1;
    return if @left != 1;
    my $input = input_of($left[0], 0);
    refuse(one_held($p) . ': ' . no_clock($left[0])) if $input eq '';
    return $input;
}
sub one_held { return (sort keys %{$_[0]{held}})[0] }

# All of them, by name.
sub found_clocks {
    my (%clocks, @open);
    for my $p (@_) {
        my $clock = likely_clock($p);
        $clocks{$clock} = 1 if defined $clock;
        push @open, $p if !defined $clock;
    }
    for my $p (@open) {
        my @nets = map { $_->[1] } @{$p->{edges}};
        refuse(one_held($p) . ': a register on the edges of ' . join(' and ', @nets)
              . ': --clock says which is its clock')
          if !grep { $clocks{input_of($_, 0)} } @nets;
    }
    return sort keys %clocks;
}

# Gives each process its clock, one of those, and leaves its other edges; which edge of each clock it is.
# An error where a process has none of them, and where both edges of one are taken.
sub give_clocks {
    my ($clocks, $is_one, @processes) = @_;
    my %is_clock = map { $_ => 1 } @$clocks;
    my $of_design = @$clocks > 1 ? 'those of the design are ' : 'that of the design is ';
    $of_design .= join ' and ', @$clocks;
    my (%way, %first);
    for my $p (@processes) {
        my $named = one_held($p);
        my (@own, @others);
        for my $edge (@{$p->{edges}}) {
            my ($way, $net) = @$edge;
            my $input = input_of($net, 0);
            if ($is_clock{$input}) { push @own, [$way, $input] } else { push @others, $edge }
        }
        if (@own != 1) {
            my ($way, $net) = $others[0] ? @{$others[0]} : ('', join ' and ', map { $_->[1] } @own);
            refuse("$named: a register on the falling edge of $net") if $way eq 'NEG' && @others == 1;
            refuse("$named: " . no_clock($net)) if $net !~ / / && no_input($net);
            refuse("$named: its clock is $net, and $of_design");
        }
        my ($way, $clock) = @{$own[0]};
        refuse("$named: a register on the falling edge of $clock") if $way ne 'POS' && $is_one;
        $way{$clock} //= $way;
        $first{$clock} //= $named;
        refuse("$named and $first{$clock}: registers on both edges of $clock") if $way{$clock} ne $way;
        $p->{clock} = $clock;
        $p->{others} = \@others;
    }
    for my $clock (@$clocks) {
        refuse("$clock: a clock of $info{$clock}{bits} bits") if $info{$clock}{bits} != 1;
    }
    return \%way;
}
# An error where a clock is more than one: of several, what is worked out from one is another thing before
# its edge and after it.
sub require_plain {
    my ($clock) = @_;
    for my $net (sort { $a cmp $b } keys %{carriers($clock)}) {
        refuse("$net: an output that is the clock $clock") if $outputs{$net};
        refuse("$net: a clock that is read as a value") if $valued{$net};
    }
    return;
}
# What is said of a clock that is no input: what makes it too, a clock gate or a divider that is an instance.
sub no_clock {
    my ($net) = @_;
    my %reach = map { $_ => carriers($_) } keys %info;
    my ($from) = sort { keys %{$reach{$b}} <=> keys %{$reach{$a}} || $a cmp $b }
      grep { exists $reach{$_}{$net} } keys %reach;
    my $maker = ($from // $net) ne $net ? ", made by $from" : '';
    return "its clock is $net$maker, which is no input";
}
sub no_input { return input_of($_[0], 0) . input_of($_[0], 1) eq '' }

1;
