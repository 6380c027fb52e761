# This repository in a container, by an ordinary user: the packages of apt-packages.txt, then the README's two commands.
#   docker build -t breathers .                         on Debian 12; with --build-arg RELEASE=trixie on Debian 13
#   docker build -t breathers --build-arg SNAPSHOT=20261101T000000Z .    with that day's packages, from snapshot.debian.org
#   docker run --rm -it breathers                       a shell beside the programs, tables and figures
# `make container` tries these steps one by one where no container can run.
ARG RELEASE=bookworm
FROM debian:${RELEASE}

# An old list of packages has run out, and is what is wanted here
ARG SNAPSHOT=
RUN [ -z "${SNAPSHOT:-}" ] || { \
  sed -i "s,http://deb.debian.org/\(debian[a-z-]*\),http://snapshot.debian.org/archive/\1/$SNAPSHOT," /etc/apt/sources.list.d/debian.sources \
  && echo 'Acquire::Check-Valid-Until "false";' > /etc/apt/apt.conf.d/snapshot; }

# What the README asks for, and what the list has for figures, tests and book
RUN apt-get update -qq \
 && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends g++ cmake make git \
 && rm -rf /var/lib/apt/lists/*
WORKDIR /home/reader/breathers
COPY apt-packages.txt tools/install-deps.sh /tmp/
RUN sh /tmp/install-deps.sh /tmp/apt-packages.txt book \
 && rm -rf /var/lib/apt/lists/*

# Nothing that follows is done as root
RUN useradd --create-home --shell /bin/bash reader && chown reader: /home/reader /home/reader/breathers
USER reader
COPY --chown=reader . .
RUN make figures
RUN make test
CMD ["bash"]
