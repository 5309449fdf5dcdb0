package org.dfra.recruit.agent;

import java.time.InstantSource;
import org.dfra.core.lease.LeaseBook;
import org.dfra.recruit.transport.Transport;
import org.dfra.time.Scheduler;

/**
 * What an agent reaches the world by.
 *
 * @param transport the other agents
 * @param body its robot
 * @param leases the module's own, in which requesters hold the lease on it while it helps them
 * @param clock what time it is, by the robot's time
 * @param scheduler wakes it, by the robot's time
 */
public record RecruiterPorts(
    Transport transport, Body body, LeaseBook leases, InstantSource clock, Scheduler scheduler) {}
