package org.dfra.persona;

import java.io.Serializable;

/**
 * One group of attributes of a module or a robot, a queryable part of its persona.
 *
 * <p>Every implementation is a public record. Its components are texts, numbers, booleans, enums,
 * {@link java.time.Instant}s (kept to the millisecond) or lists of texts, and a boxed or nullable
 * one may be unknown: null. Lookup services can store and compare these types. The interface is
 * open, since a device may have special attributes: its driver's package declares a record, and
 * clients can query it without any other class.
 */
public interface Attributes extends Serializable {}
