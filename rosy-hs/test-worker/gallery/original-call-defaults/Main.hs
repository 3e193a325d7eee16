main = simulate start

start :: Button -> Call
start _ = call (wait 1) callOptions {cancelOn = noCancel, onFeedback = noFeedback, onEnd = noResponse}
