/**
 * Entries: attributes as lookup services store them and match templates against.
 *
 * <pre>
 *   ModuleEntry &lt;-- ChainableEntry &lt;-- SensorEntry     LocationEntry   PoseEntry
 *                                                      GPSEntry        PersonaEntry   RecordEntry
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.entry.Entries}, which converts the records of {@link
 * org.dfra.persona} to entries and back. Each entry class {@linkplain org.dfra.river.entry.Mirrors
 * mirrors} one record, field by component. A subclass contains its superclass's record, so one
 * template finds modules of every kind. A record without an entry class is sent as a {@link
 * org.dfra.river.entry.RecordEntry}; other jars supply entry classes by {@link
 * org.dfra.river.entry.EntryClassProvider}.
 *
 * <p>A registrar compares marshalled bytes, field by field. So fields are strings, boxed numbers,
 * enums or sorted lists of strings: equal values of these have equal bytes.
 */
@NullMarked
package org.dfra.river.entry;

import org.jspecify.annotations.NullMarked;
