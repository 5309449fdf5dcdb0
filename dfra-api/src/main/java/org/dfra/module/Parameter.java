package org.dfra.module;

import java.io.Serializable;

/**
 * A parameter of a module with its current value.
 *
 * @param name its name, in lower_snake_case
 * @param value its value
 * @param description its meaning, with unit and range, for display
 * @param settable whether it can be set while the module runs
 */
public record Parameter(String name, String value, String description, boolean settable)
    implements Serializable {}
