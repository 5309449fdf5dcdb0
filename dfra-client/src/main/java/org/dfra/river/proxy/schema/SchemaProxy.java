package org.dfra.river.proxy.schema;

import java.util.UUID;
import org.dfra.flow.Schema;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ChainableProxy;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/**
 * Smart proxy of a schema.
 *
 * @param <S> the schema's interface
 */
public abstract class SchemaProxy<S extends Schema> extends ChainableProxy<S> implements Schema {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  protected SchemaProxy(
      Class<S> kind, RemoteModule server, UUID id, Identification identification) {
    super(kind, server, id, identification);
  }
}
