# The tree of a design that Verilator wrote, the first argument of rtl.pl: its modules, the types and the
# nets that it has, by their paths below the top.
use strict;
use warnings;
use FindBin;
require "$FindBin::Bin/verilator_tree.pl";

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

my $root = tree_in(text_of($ARGV[0]));

sub all_of {
    my ($node, $tag) = @_;
    return map { ($_->{tag} eq $tag ? $_ : (), all_of($_, $tag)) } @{$node->{in}};
}

our %modules = map { $_->{has}{name} => $_ } map { all_of($root, $_) } qw(module iface);
our @packages = all_of($root, 'package');
our ($top) = grep { $_->{has}{topModule} } values %modules;
refuse('Verilator names no top module') if !$top;

# Types, by their numbers.
our %types = map { $_->{has}{id} => $_ } map { @{$_->{in}} } all_of($root, 'typetable');
sub type_of {
    my $type = $types{$_[0] // ''} // {tag => '', has => {}, in => []};
    return $type if $type->{tag} !~ /^(?:ref|const|enum|member)dtype$/ || !$type->{has}{sub_dtype_id};
    return type_of($type->{has}{sub_dtype_id});
}
# The number of a node, undef where it is no constant.
sub constant {
    my ($node) = @_;
    return if !$node || $node->{tag} ne 'const' || $node->{has}{name} !~ /'s?h([0-9a-f]{1,8})$/;
    my $value = hex $1;
    return $value >= 2**31 && $node->{has}{name} =~ /^32's/ ? $value - 2**32 : $value;
}
# The two bounds of a range: numbers with a sign, for [N-1:0] of an unsigned N of 0 is [-1:0].
sub bounds {
    my ($range) = grep { $_->{tag} eq 'range' } @{$_[0]{in}};
    return map { defined && $_ >= 2**31 ? $_ - 2**32 : $_ } map { constant($_) } @{$range->{in}};
}
sub elements {
    my ($left, $right) = bounds($_[0]);
    return defined $right ? abs($left - $right) + 1 : 1;
}
sub first_of {
    return (sort { $a <=> $b } map { $_ // 0 } bounds($_[0]))[0] // 0;
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
    return $sum || (($has->{name} // '') =~ /^(?:double|real)$/ ? 64 : 1);
}
# The width of a net or of a word of a memory, and its words, which of a memory of several dimensions are all
# elements, those of the last index one behind the other; -1 of a queue and the like.
sub shape_of {
    my ($id, $words) = ($_[0], 0);
    while (type_of($id)->{tag} eq 'unpackarraydtype') {
        $words = ($words || 1) * elements(type_of($id));
        $id = type_of($id)->{has}{sub_dtype_id};
    }
    return (size_of($id), type_of($id)->{tag} =~ /^(?:basic|packarray|struct|union)/ ? $words : -1);
}
# 1 where it, or a word of it, is a number with a sign.
sub is_signed {
    my $type = type_of($_[0]);
    return is_signed($type->{has}{sub_dtype_id}) if $type->{tag} eq 'unpackarraydtype';
    return $type->{has}{signed} ? 1 : 0;
}

# Bits of a net, as a string of them.
sub bits { return pack 'b*', '0' x $_[0] . '1' x $_[1] }
sub without { return $_[0] ^ ($_[0] & $_[1]) }

our %info;        # net => its width, words, all its bits, and whether it is signed
our %by_name;     # name => all nets of that name
our %packaged;    # name => variables of packages
our %in_package;  # name => tasks of packages
our %alias;       # a port that is an interface => the interface

sub declare {
    my ($node, $path) = @_;
    for my $in (@{$node->{in}}) {
        my ($tag, $name) = ($in->{tag}, $in->{has}{name});
        if ($tag eq 'var') {
            next if $in->{has}{param} || $in->{has}{localparam};
            my ($width, $words) = shape_of($in->{has}{dtype_id});
            my $net = $path . $name;
            $info{$net} = {type => $in->{has}{dtype_id}, type_name => $in->{has}{vartype} // '', width => $width, words => $words, bits => $width * ($words > 0 ? $words : 1),
                signed => is_signed($in->{has}{dtype_id}),
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

1;
