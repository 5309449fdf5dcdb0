/**
 * Attacks by a stranger on the robot's network who has no key: each is run for real and must fail.
 *
 * <pre>
 *   robot, operator, attacker: addresses of 127.0.0.0/8     AttackHosts
 *   robot and attacker: two network namespaces              OtherHostAttacksIT
 *   a robot in processes of its own                         RobotProcessesIT
 *   the attacker's process and what it sends                org.dfra.benchmarks.attack
 *   threads, heap and CPU time of the robot, before, after  Victim
 * </pre>
 *
 * <p>The packages below are named by what is attacked: {@code answer} (a client's), {@code
 * discovery}, {@code event}, {@code local} (the computer), {@code registrar} and {@code stop}.
 * {@code fuzz} sends malformed bytes; {@code kit} is what the attacks share.
 *
 * <p>Enter at {@link org.dfra.attack.kit.AttackKitTest}, which shows how an attack is written.
 */
package org.dfra.attack;
