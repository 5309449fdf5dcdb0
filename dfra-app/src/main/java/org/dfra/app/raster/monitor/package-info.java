/**
 * A search by raster that goes on while time does: robots are told through their proxies to search,
 * listened to, and disturbed on the way.
 *
 * <pre>
 *   TruthSource --where they truly are--&gt; TrueTrajectory --.
 *   robots' modules --readings, by subscription--&gt; Hearing --&gt; Watch --&gt; Flight
 *        ^                                               |
 *        '-------what goes wrong------- Trouble &lt;--every moment-'
 * </pre>
 *
 * <p>Enter at {@link org.dfra.app.raster.monitor.MissionMonitor}. What the robots run on is its
 * callers': {@link org.dfra.app.raster.process} and {@link org.dfra.app.raster.embedded}.
 */
@NullMarked
package org.dfra.app.raster.monitor;

import org.jspecify.annotations.NullMarked;
