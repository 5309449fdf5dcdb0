package org.dfra.river.transport.local;

/**
 * An element of a call's server context: the user of this computer that runs the calling process,
 * as the operating system tells (SO_PEERCRED). Only calls over Unix-domain sockets have it.
 *
 * @param name the user's name
 */
public record LocalUser(String name) {}
