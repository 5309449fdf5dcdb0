package org.dfra.flow.effector;

/**
 * Marks a refusal that only people can end: the effector is {@linkplain Effector#emergencyStop
 * stopped for an emergency}. Who is refused so gives up what it was about; it does not wait for the
 * release, since then releasing would move the robot.
 */
public interface RefusedByEmergencyStop {}
