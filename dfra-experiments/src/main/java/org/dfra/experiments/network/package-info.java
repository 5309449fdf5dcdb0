/**
 * A simulated network of recruitment agents: {@link org.dfra.experiments.network.SimulatedNetwork}
 * loses, delays and counts messages.
 */
@NullMarked
package org.dfra.experiments.network;

import org.jspecify.annotations.NullMarked;
