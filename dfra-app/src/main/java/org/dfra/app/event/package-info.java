/**
 * The verbs of {@code ./dfra event}: what modules tell, how often, and how much of it.
 *
 * <pre>
 *   module --events--&gt; Listening --one at a time--&gt; EchoCommand: a line each
 *                          |                       \-&gt; Measurement: EventWindow --every second--&gt; a line
 *                          +-- ends by count, time, Ctrl-C, a closed pipe, a revoked lease
 * </pre>
 */
@NullMarked
package org.dfra.app.event;

import org.jspecify.annotations.NullMarked;
