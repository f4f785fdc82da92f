# tree_in(TEXT): the tree of a design as Verilator writes it, XML of `--xml-only` or, where that is gone (from
# 5.046 on), JSON of `--json-only`. A node has its tag, its attributes and the nodes in it, in the words of the
# XML. All that depends on the version of these formats is here.
use strict;
use warnings;
no warnings 'recursion';

sub tree_in {
    my ($text) = @_;
    return $text =~ /^\s*</ ? tree_of_xml($text) : tree_of_json($text);
}

sub tree_of_xml {
    my ($text) = @_;
    my $root = {tag => '', in => []};
    my @open = ($root);
    my %char = (apos => q{'}, quot => q{"}, lt => '<', gt => '>', amp => '&');
    while ($text =~ m{<(/?)(\w+)((?:\s+[\w:]+="[^"]*")*)\s*(/?)>}g) {
        my ($end, $tag, $attributes, $empty) = ($1, $2, $3, $4);
        if ($end) { pop @open; next }
        my %has = $attributes =~ /([\w:]+)="([^"]*)"/g;
        s/&(\w+);/$char{$1}/g for values %has;
        my $node = {tag => $tag, has => \%has, in => []};
        push @{$open[-1]{in}}, $node;
        push @open, $node if !$empty;
    }
    return $root;
}

# The XML's words for what has another in the JSON.
my %tag_of = (ASSIGNW => 'contassign', CELL => 'instance', GENBLOCK => 'begin', LOOP => 'while', PIN => 'port');

# From the place of \G behind the brace of a node; `at` has all nodes by their addresses.
sub json_node {
    my ($text, $at) = @_;
    my (%json, @in);
    while ($$text =~ /\G[\s,]*"(\w+)":\s*/gc) {
        my $key = $1;
        if ($$text =~ /\G"((?:[^"\\]|\\.)*)"/gc) {
            $json{$key} = $1 =~ s/\\(.)/$1/gr;
        } elsif ($$text =~ /\G\[/gc) {
            my @nodes;
            push @nodes, json_node($text, $at) while $$text =~ /\G[\s,]*\{/gc;
            $$text =~ /\G\s*\]/gc or refuse('the JSON of Verilator has a list of other things than nodes');
            # The two ways of a condition have a block each, an empty one too.
            @nodes = {tag => 'begin', has => {}, in => [@nodes]} if $key =~ /^(?:then|else)sp$/;
            push @in, {tag => 'begin', has => {}, in => []} if $key eq 'elsesp' && @in == 1;
            # An assignment is what a module has, not the process around it. What a static variable of a
            # function begins with is not written at each call.
            push @in, map { ($_->{has}{keyword} // '') eq 'cont_assign' ? @{$_->{in}} : $_ }
              grep { $_->{tag} ne 'initialstaticstmt' } @nodes;
        } else {
            $$text =~ /\G([\w.+-]+)/gc or refuse("the JSON of Verilator has no value of $key");
            $json{$key} = $1;
        }
    }
    $$text =~ /\G\s*\}/gc or refuse('the JSON of Verilator ends within a node');
    my $type = $json{type} // '';
    my %has = (%json, id => $json{addr}, dtype_id => $json{dtypep}, sub_dtype_id => $json{refDTypep});
    delete $has{name} if ($json{name} // '') eq '';
    @has{qw(left right)} = split /:/, $json{range} if defined $json{range};
    if ($type eq 'VAR') {
        $has{dir} = lc $json{direction} if $json{direction} ne 'NONE';
        $has{param} = 'true' if $json{varType} eq 'GPARAM';
        $has{localparam} = 'true' if $json{varType} eq 'LPARAM';
    }
    my $node = {tag => $tag_of{$type} // lc $type, has => \%has, in => \@in};
    push @in, {tag => 'const', has => {name => "32'h" . sprintf '%x', $json{widthConst}}, in => []}
      if $type eq 'SEL' && defined $json{widthConst};
    $at->{$json{addr}} = $node if defined $json{addr};
    return $node;
}

sub tree_of_json {
    my ($text) = @_;
    my %at;
    $text =~ /^\s*\{/gc or refuse('the tree of Verilator is neither XML nor JSON');
    my $root = json_node(\$text, \%at);
    my %direction = (input => 'in', output => 'out', inout => 'inout');
    for my $node (values %at) {
        my $has = $node->{has};
        $has->{defName} = $at{$has->{modp}}{has}{name} if $node->{tag} eq 'instance' && $at{$has->{modp}};
        if ($node->{tag} eq 'module') {
            $has->{topModule} = 1 if $has->{level} == 1;
            my $pin = 0;
            $_->{has}{pinIndex} = ++$pin for grep { $_->{tag} eq 'var' && $_->{has}{dir} } @{$node->{in}};
        } elsif ($node->{tag} eq 'port' && $at{$has->{modVarp} // ''}) {
            my $inner = $at{$has->{modVarp}}{has};
            $has->{name} = $inner->{name};
            $has->{direction} = $direction{$inner->{dir} // ''};
        }
    }
    return $root;
}

1;
