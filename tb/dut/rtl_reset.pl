# What a reset gives to the registers, told from the text of their processes: constants are carried
# through conditions that the reset decides (constant propagation).
use strict;
use warnings;

our (%info, %inputs, %reached);

# The constant that an expression is while inputs have the levels of `active`, in hexadecimal; undef
# where it is none.
sub known {
    my ($node, $scope, $active) = @_;
    my ($tag, @in) = ($node->{tag}, @{$node->{in}});
    if ($tag eq 'const') {
        return $1 =~ s/^0+(?=.)//r if $node->{has}{name} =~ /'s?h([0-9a-f]+)$/;
        return;
    }
    if ($tag =~ /^varx?ref$/) {
        my ($net) = nets_of($node, $scope);
        for my $input (defined $net ? keys %$active : ()) {
            return $active->{$input} if $reached{$input}{"0 $net"};
            return 1 - $active->{$input} if $reached{$input}{"1 $net"};
        }
        return;
    }
    my @known = map { scalar known($_, $scope, $active) } @in[0 .. ($tag eq 'cond' ? 0 : $#in)];
    return if !grep { defined } @known;
    if ($tag eq 'cond') {
        return known($in[$known[0] eq '0' ? 2 : 1], $scope, $active);
    }
    return '0' if $tag =~ /^(?:log)?and$/ && grep { defined && $_ eq '0' } @known;
    return '1' if $tag eq 'logor' && grep { defined && $_ ne '0' } @known;
    my $is_bit = size_of($node->{has}{dtype_id}) == 1;
    return '1' if $tag eq 'or' && $is_bit && grep { ($_ // '') eq '1' } @known;
    return if grep { !defined } @known;
    return $known[0] if $tag =~ /^extends?$/ && ($tag eq 'extend' || $known[0] eq '0');
    return $known[0] eq '0' ? '1' : '0'
      if $tag eq 'lognot' || ($tag eq 'not' && $is_bit);
    return $known[0] eq $known[1] ? '1' : '0' if $tag =~ /^eq(?:case)?$/;
    return $known[0] eq $known[1] ? '0' : '1' if $tag =~ /^neq(?:case)?$/;
    return '0' if $tag =~ /^(?:log)?or$/;
    return '0' if $tag =~ /^(?:replicate|shiftl|sel)$/ && $known[0] eq '0';
    return '0' if $tag eq 'concat' && "@known" eq '0 0';
    return '1' if $tag =~ /^(?:logand|and)$/ && "@known" eq '1 1';
    return;
}

# Puts into `given` what a process assigns, net => its constant; undef where it is none.
sub assigned {
    my ($node, $scope, $active, $given, $unsure) = @_;
    my ($tag, @in) = ($node->{tag}, @{$node->{in}});
    return if $tag =~ /^(?:sentree|var)$/;
    if ($tag =~ /^assign/ && @in > 1) {
        my $value = known($in[0], $scope, $active);
        my $is_whole = $in[1]{tag} =~ /^varx?ref$/;
        for my $place (places($in[1], [])) {
            for my $net (nets_of($place->[0], $scope)) {
                # All words of a memory, and all bits of a net, are 0 where each is.
                my $was_zero = !exists $given->{$net} || ($given->{$net} // '') eq '0';
                my $is_zero = defined $value && $value eq '0' && $was_zero;
                $given->{$net} = !$unsure && ($is_whole || $is_zero) ? $value : undef;
            }
        }
    } elsif ($tag eq 'if') {
        my $value = known($in[0], $scope, $active);
        my @ways = !defined $value ? @in[1 .. $#in] : $value eq '0' ? @in[2 .. $#in] : $in[1];
        assigned($_, $scope, $active, $given, $unsure || !defined $value) for @ways;
    } elsif ($tag eq 'case') {
        assigned($_, $scope, $active, $given, 1) for @in[1 .. $#in];
    } elsif ($tag eq 'begin') {
        my $name = $node->{has}{name};
        my $inner = defined $name ? scope_in($node, "$scope->{path}$name.", $scope) : $scope;
        assigned($_, $inner, $active, $given, $unsure) for @in;
    } elsif ($tag !~ /^(?:task|func)ref$/) {
        assigned($_, $scope, $active, $given, $unsure) for @in;
    }
    return;
}
sub given_by {
    my ($active, @processes) = @_;
    my %all;
    assigned($_->{body}, $_->{scope}, $active, \%all, 0) for @processes;
    return \%all;
}
# Of the inputs that are called so, the one and its level that give the most registers a constant.
sub synchronous_reset {
    my ($wanted, @processes) = @_;
    my ($best, $most) = (undef, 0);
    my @names = grep { /rst|reset|clr|clear/i && $info{$_}{bits} == 1 } sort keys %inputs;
    @names = $wanted if defined $wanted;
    my $always = given_by({}, @processes);
    for my $name (@names) {
        for my $level (1, 0) {
            my $given = given_by({$name => $level}, @processes);
            my $count = grep { defined $given->{$_} && !defined $always->{$_} } keys %$given;
            ($best, $most) = ([$name, $level], $count) if $count > $most;
        }
    }
    return $best;
}

# Prints what rtl.pl says of the resets of `registers`: lines synchronous, given and value.
sub tell_resets {
    my ($wanted, $asynchronous, $inner, $registers, $processes, $initial) = @_;
    refuse("$wanted: the RTL has no such input, but it is named as its reset")
      if defined $wanted && !$inputs{$wanted};
    my %active = map { /^(low )?(.*)$/ && ($2 => $1 ? 0 : 1) } @$asynchronous, @$inner;
    my @at_once = sort keys %active;
    # Each clock may have one of its own; a clock of registers that are reset at once needs none.
    my %by_clock;
    push @{$by_clock{$_->{clock}}}, $_ for @$processes;
    for my $clock (sort keys %by_clock) {
        next if grep { @{$_->{others}} && !$_->{is_inner} } @{$by_clock{$clock}};
        next if keys %by_clock == 1 && @$asynchronous;
        my $found = synchronous_reset($wanted, @{$by_clock{$clock}}) or next;
        my ($name, $level) = @$found;
        next if exists $active{$name};
        $active{$name} = $level;
        print 'synchronous ', $level ? '' : 'low ', "$name\n";
    }
    for my $reset (keys %active > 1 || @$inner ? @at_once : ()) {
        my $given = given_by({$reset => $active{$reset}}, @$processes);
        print "given $reset $_ $given->{$_}\n" for grep { defined $given->{$_} } @$registers;
    }
    my $values = given_by(\%active, %active ? @$processes : @$initial);
    print "value $_ $values->{$_}\n" for grep { defined $values->{$_} } @$registers;
    return;
}

1;
