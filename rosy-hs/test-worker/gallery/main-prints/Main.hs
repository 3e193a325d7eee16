main = print "hello"
