#!/usr/bin/env perl
# rtl_shape.pl TREE
#
# What the tree of a design says of its shape. On standard output, a line each:
#
#   top NAME
#   port WAY NAME                input or output
#   parameter NAME VALUE         of the top module, a whole number of 32 bits that can be set
#   net NAME WIDTH WORDS SIGNED  any net, by its path below the top; WORDS as rtl.pl has them; 1: signed
#   part NET NAME HIGH LOW SIGNED ENUM
#                                a member of a struct, by its path in it, the highest bits first; or the net itself,
#                                NAME -, if its type is an enum; ENUM is that, or -
#   enum ENUM NAME...            its values from 0 on
use strict;
use warnings;
use FindBin;
require "$FindBin::Bin/rtl_tree.pl";

our ($top, %info, %types);
declare($top, '');
print "top $top->{has}{origName}\n";
print "net $_ $info{$_}{width} $info{$_}{words} $info{$_}{signed}\n" for sort keys %info;

# Enums with values from 0 on. Verilator 5.006 has of a net's type the number of its bits and the enum's name.
my (%enums, %values);
for my $enum (grep { $_->{tag} eq 'enumdtype' } map { $types{$_} } sort keys %types) {
    my @items = grep { $_->{tag} eq 'enumitem' } @{$enum->{in}};
    my %at = map { constant($_->{in}[0]) // '' => $_->{has}{name} } @items;
    my $name = $enum->{has}{name} =~ s/.*[.:]//r;
    my $text = join ' ', map { $at{$_} // '' } 0 .. $#items;
    push @{$enums{$name}}, {text => $text, is_plain => keys %at == grep({ exists $at{$_} } 0 .. $#items)};
}
sub enum_of {
    my ($name) = @_;
    my ($first, @others) = @{$enums{$name} // return '-'};
    return '-' if !$first->{is_plain} || grep { $_->{text} ne $first->{text} } @others;
    $values{$name} = $first->{text};
    return $name;
}
# The parts of a type whose lowest bit is LOW.
sub parts_of {
    my ($name, $id, $low) = @_;
    my ($type, $at) = (type_of($id), $low + size_of($id));
    return [$name, $at - 1, $low, is_signed($id), '-'] if $type->{tag} ne 'structdtype';
    my @parts;
    for my $member (@{$type->{in}}) {
        my $of = $member->{has}{sub_dtype_id} // $member->{has}{id};
        $at -= size_of($of);
        push @parts, parts_of(($name eq '-' ? '' : "$name.") . $member->{has}{name}, $of, $at);
    }
    return @parts;
}
for my $net (grep { !$info{$_}{words} } sort keys %info) {
    my @parts = parts_of('-', $info{$net}{type}, 0);
    $parts[0][4] = enum_of($info{$net}{type_name}) if @parts == 1;
    next if grep { $_->[0] !~ /^(?:-|\w+(?:\.\w+)*)$/ } @parts;
    print "part $net @$_\n" for grep { @parts > 1 || $_->[4] ne '-' } @parts;
}
print "enum $_ $values{$_}\n" for sort keys %values;

my @ports = grep { $_->{tag} eq 'var' && $_->{has}{dir} } @{$top->{in}};
for my $port (sort { $a->{has}{pinIndex} <=> $b->{has}{pinIndex} } @ports) {
    print "port $port->{has}{dir} $port->{has}{name}\n";
}
for my $parameter (grep { $_->{tag} eq 'var' && $_->{has}{param} } @{$top->{in}}) {
    my ($value) = map { constant($_) } @{$parameter->{in}};
    my $type = type_of($parameter->{has}{dtype_id});
    next if !defined $value || $type->{tag} ne 'basicdtype' || size_of($parameter->{has}{dtype_id}) != 32;
    print "parameter $parameter->{has}{name} $value\n";
}
