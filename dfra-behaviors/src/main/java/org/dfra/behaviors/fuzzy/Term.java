package org.dfra.behaviors.fuzzy;

/**
 * A word for some of a variable's values, such as {@code close}.
 *
 * @param name the word; several terms of a variable may have the same
 * @param function what it stands for
 */
public record Term(String name, TermFunction function) {}
