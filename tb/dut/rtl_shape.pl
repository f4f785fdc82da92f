#!/usr/bin/env perl
# rtl_shape.pl TREE.xml
#
# What the tree of a design says of its shape. On standard output, a line each:
#
#   top NAME
#   port WAY NAME WIDTH WORDS    input or output
#   parameter NAME VALUE         of the top module, a whole number of 32 bits that can be set
#   net NAME WIDTH WORDS         any net, by its path below the top; WORDS as rtl.pl has them
use strict;
use warnings;
use FindBin;
require "$FindBin::Bin/rtl_tree.pl";

our ($top, %info);
declare($top, '');
print "top $top->{has}{origName}\n";
my @ports = grep { $_->{tag} eq 'var' && $_->{has}{dir} } @{$top->{in}};
for my $port (sort { $a->{has}{pinIndex} <=> $b->{has}{pinIndex} } @ports) {
    my $name = $port->{has}{name};
    print "port $port->{has}{dir} $name $info{$name}{width} $info{$name}{words}\n";
}
for my $parameter (grep { $_->{tag} eq 'var' && $_->{has}{param} } @{$top->{in}}) {
    my ($value) = map { constant($_) } @{$parameter->{in}};
    my $type = type_of($parameter->{has}{dtype_id});
    next if !defined $value || $type->{tag} ne 'basicdtype' || size_of($parameter->{has}{dtype_id}) != 32;
    print "parameter $parameter->{has}{name} $value\n";
}
print "net $_ $info{$_}{width} $info{$_}{words}\n" for sort keys %info;
