package org.dfra.river.remote.behavior;

import org.dfra.behavior.RasterGoal;
import org.dfra.behavior.RasterSearch;

/** What clients may call on the server of a script that searches by raster. */
public interface RemoteRasterSearch extends RemoteBehavior<RasterGoal>, RasterSearch {}
