main = simulate same

same x = x
