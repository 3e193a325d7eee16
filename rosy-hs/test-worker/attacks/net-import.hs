import Network.Socket

main = socket AF_INET Stream 0 >>= \_ -> simulate (Say "HARM")
