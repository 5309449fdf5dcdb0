/**
 * Entries: attributes as lookup services store them and match templates against.
 *
 * <pre>
 *   ModuleEntry &lt;-- ChainableEntry &lt;-- SensorEntry     LocationEntry   PoseEntry
 *                                                      GPSEntry        PersonaEntry   RecordEntry
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.entry.Entries}, which turns the records of {@link
 * org.dfra.persona} into entries and back. Each entry class {@linkplain
 * org.dfra.river.entry.Mirrors mirrors} one record, field by component; a subclass carries its
 * superclass's record along, so one template finds modules of every kind. Records without an entry
 * class of their own travel as {@link org.dfra.river.entry.RecordEntry}; other jars bring entry
 * classes along by {@link org.dfra.river.entry.EntryClassProvider}.
 *
 * <p>A registrar compares marshalled bytes, field by field: fields are texts, boxed numbers, enums
 * or sorted lists of texts, since equal ones of these have equal bytes.
 */
@NullMarked
package org.dfra.river.entry;

import org.jspecify.annotations.NullMarked;
