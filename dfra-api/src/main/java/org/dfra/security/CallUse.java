package org.dfra.security;

/**
 * What a call has used of its robot.
 *
 * @param bytes sent and received on its connection, with the transport's own headers and its
 *     encryption; 0 if the transport does not count them
 * @param processorNanos processor time of the thread that served it, in nanoseconds; 0 if it was
 *     not measured
 */
public record CallUse(long bytes, long processorNanos) {}
