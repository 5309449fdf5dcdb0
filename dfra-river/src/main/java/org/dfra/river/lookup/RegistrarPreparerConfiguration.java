package org.dfra.river.lookup;

import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.security.ProxyPreparer;
import org.dfra.river.discovery.LocatedRegistrar;
import org.jspecify.annotations.Nullable;

/**
 * A configuration whose preparer receives the lookup services' proxies themselves, not their {@link
 * LocatedRegistrar} wrappers. The prepared proxies stay distinct from other lookup services that
 * claim the same service ID: River's join manager compares by equality.
 */
final class RegistrarPreparerConfiguration implements Configuration {

  private static final String COMPONENT = "net.jini.lookup.JoinManager";
  private static final String ENTRY = "registrarPreparer";

  private final Configuration own;

  /**
   * @param own supplies all entries
   */
  RegistrarPreparerConfiguration(Configuration own) {
    this.own = own;
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public @Nullable Object getEntry(String component, String name, Class type)
      throws ConfigurationException {
    return prepared(component, name, own.getEntry(component, name, type));
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public @Nullable Object getEntry(
      String component, String name, Class type, @Nullable Object fallback)
      throws ConfigurationException {
    return prepared(component, name, own.getEntry(component, name, type, fallback));
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public @Nullable Object getEntry(
      String component, String name, Class type, @Nullable Object fallback, @Nullable Object data)
      throws ConfigurationException {
    return prepared(component, name, own.getEntry(component, name, type, fallback, data));
  }

  private static @Nullable Object prepared(String component, String name, @Nullable Object value) {
    return component.equals(COMPONENT)
            && name.equals(ENTRY)
            && value instanceof ProxyPreparer preparer
        ? preparing(preparer)
        : value;
  }

  private static ProxyPreparer preparing(ProxyPreparer preparer) {
    return proxy ->
        proxy instanceof LocatedRegistrar registrar
            ? registrar.prepared(preparer)
            : preparer.prepareProxy(proxy);
  }
}
