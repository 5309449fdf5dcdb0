/**
 * Phoenix and the call layer with real processes.
 *
 * <p>Enter at {@link org.dfra.phoenix.PhoenixFixture}, which starts, kills and restarts a phoenix,
 * counts the virtual machines of its groups and leaves no process behind; {@link
 * org.dfra.phoenix.Beacon} is what the groups run.
 */
package org.dfra.phoenix;
