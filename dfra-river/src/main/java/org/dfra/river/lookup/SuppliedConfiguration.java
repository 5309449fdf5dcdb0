package org.dfra.river.lookup;

import java.util.Map;
import java.util.function.Supplier;
import net.jini.config.AbstractConfiguration;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.config.EmptyConfiguration;
import net.jini.config.NoSuchEntryException;
import org.jspecify.annotations.Nullable;

/** A Jini configuration from code: each query of an entry calls the entry's supplier. */
public final class SuppliedConfiguration extends AbstractConfiguration {

  private final Configuration first;
  private final Map<String, Supplier<?>> entries;

  /**
   * @param entries suppliers by {@code component.entry}
   */
  public SuppliedConfiguration(Map<String, Supplier<?>> entries) {
    this(EmptyConfiguration.INSTANCE, entries);
  }

  /**
   * @param first its entries take precedence
   * @param entries suppliers by {@code component.entry}
   */
  public SuppliedConfiguration(Configuration first, Map<String, Supplier<?>> entries) {
    this.first = first;
    this.entries = Map.copyOf(entries);
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public @Nullable Object getEntry(
      String component, String name, Class type, @Nullable Object fallback)
      throws ConfigurationException {
    return getEntry(component, name, type, fallback, NO_DATA);
  }

  /** Forwards an entry that has no supplier here to {@code first}, with the caller's default. */
  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public @Nullable Object getEntry(
      String component, String name, Class type, @Nullable Object fallback, @Nullable Object data)
      throws ConfigurationException {
    return entries.containsKey(component + "." + name)
        ? super.getEntry(component, name, type, fallback, data)
        : first.getEntry(component, name, type, fallback, data);
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  protected @Nullable Object getEntryInternal(
      String component, String name, Class type, @Nullable Object data)
      throws ConfigurationException {
    @Nullable Object value;
    try {
      value = first.getEntry(component, name, type, NO_DEFAULT, data);
    } catch (NoSuchEntryException e) {
      Supplier<?> supplier = entries.get(component + "." + name);
      if (supplier == null) {
        throw e;
      }
      value = supplier.get();
    }
    return type.isPrimitive() ? new Primitive(value) : value; // distinct for River
  }
}
