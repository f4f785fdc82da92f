s/if count = 0 then/if count = 1 then/
