package org.dfra.river.remote.schema;

import org.dfra.flow.perceptual.TeamTracker;

/** What clients may call on the server of a team tracker. */
public interface RemoteTeamTracker extends RemoteSchema, TeamTracker {}
