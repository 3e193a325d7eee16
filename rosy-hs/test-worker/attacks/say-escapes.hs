main = simulate (Say "\xd800\xdfff\a\ESC[2J\ESC]0;title\a\ESC]52;c;aGFybQ==\a\r\b\x9b\&2J<img src=x onerror=alert(1)>")
