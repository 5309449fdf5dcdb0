package org.dfra.river.remote.effector;

import org.dfra.flow.effector.DriveCommand;
import org.dfra.flow.effector.DriveEffector;

/** What clients may call on the server of a drive. */
public interface RemoteDriveEffector extends RemoteEffector<DriveCommand>, DriveEffector {}
