/**
 * Bootstrap: from a robot's XML to its running modules. The composition root of the distributed
 * layer.
 *
 * <pre>
 *   1 phoenix starts        2 reggie starts         3 reggie is registered
 *   4 loader is created     5 robot XML             6 module properties
 *   7 MarshalledObject, registered with phoenix     8 the same for every module
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.bootstrap.RobotBootstrap}; {@link
 * org.dfra.river.bootstrap.EmbeddedRobot} runs without phoenix, in one virtual machine.
 */
@NullMarked
package org.dfra.river.bootstrap;

import org.jspecify.annotations.NullMarked;
