# 99999999 "/etc/passwd"
main = simulate (Say missing)
