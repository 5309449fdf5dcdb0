package org.dfra.directory;

import java.rmi.RemoteException;

/** Nothing matches a query at the time of a call. */
public final class NoModuleFoundException extends RemoteException {

  private static final long serialVersionUID = 1L;

  public NoModuleFoundException(ModuleQuery<?> query) {
    super("there is no " + query + " now; start one, or ask for less");
  }
}
