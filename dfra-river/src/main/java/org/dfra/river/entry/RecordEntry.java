package org.dfra.river.entry;

import java.util.List;
import net.jini.entry.AbstractEntry;
import net.jini.lookup.entry.ServiceControlled;
import org.jspecify.annotations.Nullable;

/**
 * Attributes of a record that has no entry class of its own: a device's own. A client that has the
 * record's class gets the record back, any other one does without it.
 */
public class RecordEntry extends AbstractEntry implements ServiceControlled {

  private static final long serialVersionUID = 1L;

  /** Full name of the record's class. */
  public @Nullable String type;

  /** {@code component=value}, sorted; a list of texts gives one for each text. */
  public @Nullable List<String> values;

  /** With every field null. */
  public RecordEntry() {}
}
