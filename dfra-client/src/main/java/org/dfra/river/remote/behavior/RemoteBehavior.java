package org.dfra.river.remote.behavior;

import org.dfra.behavior.Behavior;
import org.dfra.behavior.Goal;
import org.dfra.river.remote.schema.RemoteSchema;

/**
 * What clients may call on any behaviour's server.
 *
 * @param <G> the behaviour's goal type
 */
public interface RemoteBehavior<G extends Goal> extends RemoteSchema, Behavior<G> {}
