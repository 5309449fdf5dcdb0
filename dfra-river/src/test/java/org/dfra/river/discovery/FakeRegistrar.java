package org.dfra.river.discovery;

import java.io.IOException;
import java.io.Serializable;
import java.net.InetSocketAddress;
import java.rmi.MarshalledObject;
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

/** A lookup service's proxy that knows its service ID and its group, and lists nothing. */
public final class FakeRegistrar implements ServiceRegistrar, Serializable {

  private static final long serialVersionUID = 1L;

  private final long id;
  private final String group;

  /** Two of one service ID and different groups are different lookup services. */
  public FakeRegistrar(long id, String group) {
    this.id = id;
    this.group = group;
  }

  /** The lookup service as it is found at an address. */
  public LocatedRegistrar at(String address, int port) throws IOException {
    return new LocatedRegistrar(
        this, new MarshalledInstance(this), new InetSocketAddress(address, port));
  }

  @Override
  public ServiceID getServiceID() {
    return new ServiceID(0, id);
  }

  @Override
  public String[] getGroups() {
    return new String[] {group};
  }

  @Override
  public LookupLocator getLocator() {
    return new LookupLocator("192.0.2.1", 4160); // reserved for documentation
  }

  @Override
  public ServiceRegistration register(ServiceItem item, long millis) {
    throw new UnsupportedOperationException();
  }

  @Override
  public Object lookup(ServiceTemplate template) {
    throw new UnsupportedOperationException();
  }

  @Override
  public ServiceMatches lookup(ServiceTemplate template, int most) {
    return new ServiceMatches(new ServiceItem[0], 0);
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public EventRegistration notify(
      ServiceTemplate template,
      int transitions,
      RemoteEventListener listener,
      MarshalledObject handback,
      long millis) {
    throw new UnsupportedOperationException();
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public Class[] getEntryClasses(ServiceTemplate template) {
    throw new UnsupportedOperationException();
  }

  @Override
  public Object[] getFieldValues(ServiceTemplate template, int set, String field) {
    return new Object[0];
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public Class[] getServiceTypes(ServiceTemplate template, String prefix) {
    throw new UnsupportedOperationException();
  }
}
