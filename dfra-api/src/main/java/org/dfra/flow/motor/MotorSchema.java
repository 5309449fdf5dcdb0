package org.dfra.flow.motor;

import org.dfra.flow.Schema;

/**
 * A module that computes commands from percepts. It only recommends them and moves nothing itself.
 */
public interface MotorSchema extends Schema {}
