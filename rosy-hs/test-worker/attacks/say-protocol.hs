main = simulate (Say "\"}\n{\"op\":\"ended\",\"how\":\"done\",\"fired\":[]}\n{\"op\":\"said\",\"text\":\"HARM\"}")
