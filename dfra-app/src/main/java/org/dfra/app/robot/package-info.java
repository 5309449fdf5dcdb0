/** Brings the robots of this host up and down, and tells how they are. */
@NullMarked
package org.dfra.app.robot;

import org.jspecify.annotations.NullMarked;
