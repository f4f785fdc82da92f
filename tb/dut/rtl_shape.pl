#!/usr/bin/env perl
# rtl_shape.pl TREE
#
# What the tree of a design says of its shape. On standard output, a line each:
#
#   top NAME
#   port WAY NAME                input or output
#   parameter NAME VALUE         of the top module, a whole number of 32 bits that can be set
#   net NAME WIDTH WORDS SIGNED  any net, by its path below the top; WORDS as rtl.pl has them; 1: signed
use strict;
use warnings;
use FindBin;
require "$FindBin::Bin/rtl_tree.pl";

our ($top, %info);
declare($top, '');
print "top $top->{has}{origName}\n";
print "net $_ $info{$_}{width} $info{$_}{words} $info{$_}{signed}\n" for sort keys %info;
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
