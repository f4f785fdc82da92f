#!/usr/bin/env perl
# rtl_yosys.pl NETLIST.json
#
# Reads a flat netlist that yosys wrote behind `proc; flatten`. On standard output, a line each:
#
#   held NAME:BIT:WIDTH...   a bit of a register that an output depends on, by all its names: of bit
#                            BIT of a net of WIDTH bits
#   memory NAME              a memory that is written and that an output depends on
#   latch NAME:BIT:WIDTH...  a bit of a latch that an output depends on
use strict;
use warnings;
use JSON::PP ();

# Which is a part of perl; JSON::XS does the same and takes a twentieth of the time.
my $json = eval { require JSON::XS } ? 'JSON::XS' : 'JSON::PP';

open my $file, '<', $ARGV[0] or die "$ARGV[0]: $!\n";
my $design = $json->new->utf8->decode(do { local $/; <$file> });
my ($top) = grep { $_->{attributes}{top} } values %{$design->{modules}};
exit 0 if !$top;

my %names;  # bit => its names
for my $name (sort keys %{$top->{netnames}}) {
    my $net = $top->{netnames}{$name};
    next if $net->{hide_name};
    my @bits = @{$net->{bits}};
    push @{$names{$bits[$_]}}, "$name:$_:" . scalar @bits for 0 .. $#bits;
}
my (%driver, %writers);
for my $cell (values %{$top->{cells}}) {
    my $id = ($cell->{parameters}{MEMID} // '') =~ s/^\\//r;
    push @{$writers{$id}}, $cell if $cell->{type} =~ /^\$memwr/;
    for my $port (grep { $cell->{port_directions}{$_} ne 'input' } keys %{$cell->{connections}}) {
        $driver{$_} = $cell for @{$cell->{connections}{$port}};
    }
}

# From the outputs back.
my @left = map { @{$_->{bits}} } grep { $_->{direction} ne 'input' } values %{$top->{ports}};
my (%live, %seen, %memories);
while (defined(my $bit = shift @left)) {
    next if $live{$bit}++ || !$driver{$bit};
    my @cells = $driver{$bit};
    if ($cells[0]{type} =~ /^\$memrd/) {
        my $id = $cells[0]{parameters}{MEMID} =~ s/^\\//r;
        push @cells, @{$writers{$id} // []};
        $memories{$id} = 1 if $writers{$id};
    }
    for my $cell (grep { !$seen{$_}++ } @cells) {
        my $way = $cell->{port_directions};
        push @left, map { @{$cell->{connections}{$_}} } grep { $way->{$_} ne 'output' } keys %$way;
    }
}

print "memory $_\n" for sort keys %memories;
for my $cell (values %{$top->{cells}}) {
    my ($kind) = $cell->{type} =~ /^\$.*(ff|latch|sr)/ or next;
    # One that is open at all times is none.
    next if $kind eq 'latch' && ($cell->{connections}{EN}[0] // '') eq substr $cell->{parameters}{EN_POLARITY} // 'x', -1;
    my ($q, $d) = map { $cell->{connections}{$_} // [] } qw(Q D);
    # A constant, "0", "1" or "x", that is driven besides is no place where one holds anything.
    for my $i (grep { $q->[$_] !~ /^[01xz]$/ && $live{$q->[$_]} && $names{$q->[$_]} } 0 .. $#$q) {
        # What takes the same number on every clock, as the variable of a loop, holds nothing.
        next if $cell->{type} eq '$dff' && $d->[$i] =~ /^[01x]$/;
        print join(' ', $kind eq 'latch' ? 'latch' : 'held', @{$names{$q->[$i]}}), "\n";
    }
}
