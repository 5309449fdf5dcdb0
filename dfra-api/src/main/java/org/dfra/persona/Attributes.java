package org.dfra.persona;

import java.io.Serializable;

/**
 * One group of attributes of a module or a robot, the part of its persona that a query can ask for.
 *
 * <p>Every implementation is a public record. Its components are texts, numbers, booleans, enums,
 * {@link java.time.Instant}s (kept to the millisecond) or lists of texts, and a boxed or nullable
 * one may be unknown: null. That is what lookup services can store and compare. The interface is
 * open, since a device has attributes that nobody foresaw: its driver's package declares a record,
 * and no other class is needed for others to query it.
 */
public interface Attributes extends Serializable {}
