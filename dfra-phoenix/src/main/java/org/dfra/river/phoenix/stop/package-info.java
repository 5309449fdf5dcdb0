/**
 * The emergency stop by phoenix: it needs no lookup service, no registered proxy and no downloaded
 * class.
 *
 * <pre>
 *   ./dfra stop --StopService--&gt; phoenix --StoppableGroup--&gt; each group's VM --StopTarget--&gt; effector
 *        ^------ StopReport ------'  ^---- GroupStopResult ---'  ^---- EmergencyStopState -----'
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.phoenix.stop.StopService}, and find one with {@link
 * org.dfra.river.phoenix.stop.StopLocator}. Nothing here can release a stop.
 */
@NullMarked
package org.dfra.river.phoenix.stop;

import org.jspecify.annotations.NullMarked;
