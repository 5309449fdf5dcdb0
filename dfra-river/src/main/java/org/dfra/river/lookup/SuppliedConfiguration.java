package org.dfra.river.lookup;

import java.util.Map;
import java.util.function.Supplier;
import net.jini.config.AbstractConfiguration;
import net.jini.config.NoSuchEntryException;
import org.jspecify.annotations.Nullable;

/** A Jini configuration made in code: each entry is supplied anew whenever it is asked for. */
public final class SuppliedConfiguration extends AbstractConfiguration {

  private final Map<String, Supplier<?>> entries;

  /**
   * @param entries suppliers by {@code component.entry}
   */
  public SuppliedConfiguration(Map<String, Supplier<?>> entries) {
    this.entries = Map.copyOf(entries);
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  protected Object getEntryInternal(
      String component, String name, Class type, @Nullable Object data)
      throws NoSuchEntryException {
    Supplier<?> supplier = entries.get(component + "." + name);
    if (supplier == null) {
      throw new NoSuchEntryException("no entry " + component + "." + name);
    }
    Object value = supplier.get();
    return type.isPrimitive() ? new Primitive(value) : value; // so River tells long from Long
  }
}
