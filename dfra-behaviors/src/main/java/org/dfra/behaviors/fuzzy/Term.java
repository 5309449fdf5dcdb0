package org.dfra.behaviors.fuzzy;

/**
 * A linguistic term of a variable, such as {@code close}.
 *
 * @param name its name; several terms of a variable may share it
 * @param function its meaning
 */
public record Term(String name, TermFunction function) {}
