package org.dfra.flow.effector;

/**
 * Marks a refusal that only an operator can end: the effector is in an {@linkplain
 * Effector#emergencyStop emergency stop}. A refused client cancels its task. It does not wait for
 * the release, since then the release would move the robot.
 */
public interface RefusedByEmergencyStop {}
