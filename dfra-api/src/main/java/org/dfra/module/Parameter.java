package org.dfra.module;

import java.io.Serializable;

/**
 * A parameter of a module as it is set now.
 *
 * @param name its name, in lower_snake_case
 * @param value its value
 * @param description what it means, with unit and range, for people
 * @param settable whether it can be set while the module runs
 */
public record Parameter(String name, String value, String description, boolean settable)
    implements Serializable {}
