package org.dfra.river.server.schema;

import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationID;
import org.dfra.core.module.ModuleImpl;
import org.dfra.flow.Schema;
import org.dfra.river.remote.schema.RemoteSchema;
import org.dfra.river.server.ChainableServer;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/**
 * Activatable server of a schema.
 *
 * @param <S> the schema's interface
 */
public abstract class SchemaServer<S extends Schema> extends ChainableServer<S>
    implements RemoteSchema {

  /** See {@link ModuleServer#ModuleServer}. */
  protected SchemaServer(
      Class<S> kind, @Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(kind, id, data);
  }

  /**
   * As the other constructor, for a driver with a more specific base class.
   *
   * @param base what the driver must extend
   */
  protected SchemaServer(
      Class<S> kind,
      Class<? extends ModuleImpl> base,
      @Nullable ActivationID id,
      MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(kind, base, id, data);
  }
}
