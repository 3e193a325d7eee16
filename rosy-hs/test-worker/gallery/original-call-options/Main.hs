main = simulate start

start :: Button -> Call
start _ = call (wait 1) callOpts {response = \_ -> Say "done"}
