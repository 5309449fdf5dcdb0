package org.dfra.flow.motor;

import org.dfra.flow.Schema;

/** A module that makes commands of percepts. It gives advice and moves nothing itself. */
public interface MotorSchema extends Schema {}
