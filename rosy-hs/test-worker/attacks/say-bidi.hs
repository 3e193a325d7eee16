main = simulate (Say "\8238gnp.exe\8294\8297\65279\1114111")
