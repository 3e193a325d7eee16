main = simulate broken

broken :: Velocity -> Maybe Sound
broken _ = error "\xd800\xdfff\0\a\ESC[2J\ESC]0;title\a\x202e\r\n{\"op\":\"ended\",\"how\":\"done\"}\n<script>alert(1)</script>"
