/**
 * Module servers, which the activation system creates. The fourth of the five classes.
 *
 * <pre>
 *   (ActivationID, MarshalledObject) --&gt; ModuleServer
 *        1 constructed   2 properties read   3 driver class loaded   4 landlord and proxy
 *        5 discovery and join
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.server.ModuleServer}; {@link
 * org.dfra.river.server.sensor.GPSServer} shows how little a module type adds.
 */
@NullMarked
package org.dfra.river.server;

import org.jspecify.annotations.NullMarked;
