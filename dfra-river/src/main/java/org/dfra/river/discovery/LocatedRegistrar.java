package org.dfra.river.discovery;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.event.EventRegistration;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceMatches;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceRegistration;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.io.MarshalledInstance;
import net.jini.security.ProxyPreparer;
import org.jspecify.annotations.Nullable;

/**
 * A lookup service's proxy and the address where it was found. The proxy claims a service ID, and
 * any host may claim the ID of another lookup service. River's proxies with one service ID are
 * equal, so the first that answers would hide all others.
 *
 * <p>Two instances are equal only if both proxies arrived as the same bytes. Then it does not
 * matter which one is called: both call the same object at the same address. So a lookup service
 * that is found at two addresses of its computer counts once, and one that copies another's service
 * ID counts separately.
 *
 * <p>Thread-safe. Equality makes no remote call.
 */
public final class LocatedRegistrar implements ServiceRegistrar {

  private final ServiceRegistrar proxy;
  private final MarshalledInstance form;
  private final InetSocketAddress place;
  private final ServiceID id;

  /**
   * @param proxy its proxy, which knows its service ID without a call
   * @param form the bytes of the proxy, as they arrived
   * @param place the other end of the connection over which they arrived; the port is that for
   *     unicast discovery, or any port if the lookup service opened the connection
   */
  public LocatedRegistrar(
      ServiceRegistrar proxy, MarshalledInstance form, InetSocketAddress place) {
    this.proxy = proxy;
    this.form = form;
    this.place = place;
    this.id = proxy.getServiceID();
  }

  /** The address of the computer that answered. */
  public InetAddress address() {
    return place.getAddress();
  }

  /** The address where it answered, as {@code address:port}. */
  public String hostAndPort() {
    return place.getAddress().getHostAddress() + ":" + place.getPort();
  }

  /**
   * The same lookup service with a prepared proxy.
   *
   * @throws RemoteException as the preparer does
   * @throws SecurityException if the preparer does not trust the proxy, or does not return a lookup
   *     service's proxy
   */
  public LocatedRegistrar prepared(ProxyPreparer preparer) throws RemoteException {
    if (preparer.prepareProxy(proxy) instanceof ServiceRegistrar registrar) {
      return new LocatedRegistrar(registrar, form, place);
    }
    throw new SecurityException("the preparer returned something else than a lookup service");
  }

  /** The service ID that it claims. */
  @Override
  public ServiceID getServiceID() {
    return id;
  }

  @Override
  public ServiceRegistration register(ServiceItem item, long millis) throws RemoteException {
    return proxy.register(item, millis);
  }

  @Override
  public @Nullable Object lookup(ServiceTemplate template) throws RemoteException {
    return proxy.lookup(template);
  }

  @Override
  public ServiceMatches lookup(ServiceTemplate template, int most) throws RemoteException {
    return proxy.lookup(template, most);
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public EventRegistration notify(
      ServiceTemplate template,
      int transitions,
      RemoteEventListener listener,
      @Nullable MarshalledObject handback,
      long millis)
      throws RemoteException {
    return proxy.notify(template, transitions, listener, handback, millis);
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public Class @Nullable [] getEntryClasses(ServiceTemplate template) throws RemoteException {
    return proxy.getEntryClasses(template);
  }

  @Override
  public @Nullable Object @Nullable [] getFieldValues(
      ServiceTemplate template, int set, String field)
      throws NoSuchFieldException, RemoteException {
    return proxy.getFieldValues(template, set, field);
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public Class @Nullable [] getServiceTypes(ServiceTemplate template, @Nullable String prefix)
      throws RemoteException {
    return proxy.getServiceTypes(template, prefix);
  }

  @Override
  public @Nullable LookupLocator getLocator() throws RemoteException {
    return proxy.getLocator();
  }

  @Override
  public String[] getGroups() throws RemoteException {
    return proxy.getGroups();
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof LocatedRegistrar that && form.fullyEquals(that.form);
  }

  @Override
  public int hashCode() {
    return form.hashCode();
  }

  @Override
  public String toString() {
    return id + " at " + hostAndPort();
  }
}
