package org.dfra.river.entry;

import java.util.List;
import net.jini.entry.AbstractEntry;
import net.jini.lookup.entry.ServiceControlled;
import org.jspecify.annotations.Nullable;

/**
 * Attributes of a record without an entry class, such as those of one device type. A client that
 * has the record's class reads the record; other clients ignore it.
 */
public class RecordEntry extends AbstractEntry implements ServiceControlled {

  private static final long serialVersionUID = 1L;

  /** Full name of the record's class. */
  public @Nullable String type;

  /** {@code component=value}, sorted; a list of strings gives one for each string. */
  public @Nullable List<String> values;

  /** With every field null. */
  public RecordEntry() {}
}
