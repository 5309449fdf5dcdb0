/**
 * The subcommands of {@code ./dfra event}: the events that modules publish, their rate and their
 * bandwidth.
 *
 * <pre>
 *   module --events--&gt; ListeningSession --one at a time--&gt; EchoCommand: a line each
 *                          |                       \-&gt; MeasurementCommand: EventWindow,
 *                          |                                            a line every second
 *                          +-- ends by count, time, Ctrl-C, a closed pipe, a revoked lease
 * </pre>
 */
@NullMarked
package org.dfra.cli.event;

import org.jspecify.annotations.NullMarked;
