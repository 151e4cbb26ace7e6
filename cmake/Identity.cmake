# Who the program is, for packages and desktops. Everything else is made from these.
set(TXN_APP_ID org.textonstudio.studio)
set(TXN_MAINTAINER "Texton Studio contributors")
set(TXN_CONTACT texton-studio@lists.invalid)
# Of the version that CMakeLists.txt names.
set(TXN_RELEASE_DATE 2026-11-28)
set(TXN_RELEASE_DATE_RFC "Sat, 28 Nov 2026 12:00:00 +0000")
