/* three.js: The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

The rest is part of polhode, under the MIT licence. */
(()=>{var pv=Object.defineProperty;var cs=(i,e)=>{for(var t in e)pv(i,t,{get:e[t],enumerable:!0})};var tl=`zero or of a size from ${1e-100} to ${1e100}`,Rh=i=>i===0||typeof i=="number"&&Math.abs(i)>=1/1e100&&Math.abs(i)<=1e100;function Tn(i){let e=String(JSON.stringify(i,(t,n)=>typeof n=="number"&&!Number.isFinite(n)?String(n):n));return e.length>60?`${e.slice(0,60)}\u2026`:e}function Ch(i,e,t,n=""){if(Object.hasOwn(i,e))return i[e];throw new RangeError(`There is no ${t} ${(n+e).slice(0,60)} here; there are ${Object.keys(i).join(", ")}.`)}function Bp(i){let e=[];for(let[t,n]of Object.entries(i))if(typeof n!="object")e.push(`${t}=${Op(n)}`);else for(let[s,r]of Object.entries(n))e.push(`${t}.${s}=${Op(r)}`);return e.join("&")}var Op=i=>[i].flat().map(e=>typeof e=="number"?String(e):encodeURIComponent(e)).join(",");function nl(i){let e=Object.create(null),t=[];for(let n of i.replace(/^#/,"").split("&").filter(Boolean))try{mv(e,n)}catch(s){t.push(s)}return{tables:e,refused:t}}function mv(i,e){let[t,...n]=e.split("="),[s,r,...o]=t.split(".");if(!s||r===""||o.length)throw new RangeError(`The link must name what it sets, as in spin.rate=2; got ${Tn(e)}. Leave that out.`);let a=gv(t,n.join("="));if(r===void 0){i[s]=a;return}let l=i[s]??=Object.create(null);if(typeof l!="object"||Array.isArray(l))throw new RangeError(`${s} must be a value or a table; got both in the link. Leave out ${s}, or ${Tn(t)}.`);l[r]=a}function gv(i,e){let t;try{t=decodeURIComponent(e)}catch{throw new RangeError(`${i.slice(0,60)} must have whole escapes like %20; got ${Tn(e)}. Write the value without %.`)}let n=t.split(",").map(r=>r.trim()===""?NaN:Number(r));if(n.length===1&&!Number.isFinite(n[0]))return t;if(n.every(Rh))return n.length===1?n[0]:n;let s=n.length===1?"":"numbers between commas, each ";throw new RangeError(`${i.slice(0,60)} must be ${s}${tl}; got ${Tn(t)}. Check the number, which is in SI units.`)}var xv=300,il=class{constructor(e,t){this.seen=e,window.addEventListener("hashchange",()=>{window.location.hash.slice(1)!==this.fragment&&t(this.read())})}read(){return nl(window.location.hash)}get fragment(){return Bp(this.seen())}get whole(){let{protocol:e,href:t}=window.location;if(e==="about:")return null;let n=this.fragment;return t.split("#")[0]+(n?`#${n}`:"")}changed(){clearTimeout(this.waiting),this.waiting=setTimeout(()=>this.write(),xv)}write(){clearTimeout(this.waiting);let{whole:e}=this;if(!(e===null||e===window.location.href))try{window.history.replaceState(null,"",e)}catch{}}};var vm=0,ad=1,Mm=2;var da=1,bm=2,qr=3,bs=0,vn=1,Si=2,er=0,Xr=1,ld=2,cd=3,ud=4,Sm=5;var tr=100,wm=101,Am=102,Em=103,Tm=104,Rm=200,Cm=201,Im=202,Pm=203,hd=204,dd=205,Lm=206,Nm=207,Dm=208,Um=209,Fm=210,Om=211,Bm=212,km=213,zm=214,Ul=0,Fl=1,Ol=2,Nr=3,Bl=4,kl=5,zl=6,Gl=7,fa=0,Gm=1,Vm=2,wi=0,fd=1,pd=2,md=3,gd=4,xd=5,yd=6,_d=7;var vd=300,nr=301,$r=302,fc=303,pc=304,Vl=1e3,vi=1001,Hl=1002,qt=1003,Hm=1004;var pa=1005;var Ft=1006,mc=1007;var Yi=1008;var In=1009,Md=1010,bd=1011,Yr=1012,gc=1013,ui=1014,ei=1015,hi=1016,xc=1017,yc=1018,ir=1020,Sd=35902,wd=35899,Ad=1021,Ed=1022,di=1023,qi=1026,Zi=1027,_c=1028,vc=1029,Ss=1030,Mc=1031;var bc=1033,ma=33776,ga=33777,xa=33778,ya=33779,Sc=35840,wc=35841,Ac=35842,Ec=35843,Tc=36196,Rc=37492,Cc=37496,Ic=37488,Pc=37489,_a=37490,Lc=37491,Nc=37808,Dc=37809,Uc=37810,Fc=37811,Oc=37812,Bc=37813,kc=37814,zc=37815,Gc=37816,Vc=37817,Hc=37818,Wc=37819,qc=37820,Xc=37821,$c=36492,Yc=36494,Zc=36495,jc=36283,Kc=36284,va=36285,Jc=36286;var Oo=2300,Wl=2301,Nl=2302,Qh=2303,ed=2400,td=2401,nd=2402;var Wm=3200;var Zr=0,qm=1,ji="",Un="srgb",Bo="srgb-linear",ko="linear",rt="srgb";var Dl=7680;var Xm=519,$m=512,Ym=513,Zm=514,Td=515,jm=516,Km=517,Rd=518,Cd=519,Id=35044;var Pd="300 es",jn=2e3,Dr=2001;function yv(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function _v(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function zo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Jm(){let i=zo("canvas");return i.style.display="block",i}var kp={},Ur=null;function Go(...i){let e="THREE."+i.shift();Ur?Ur("log",e,...i):console.log(e,...i)}function Qm(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ie(...i){i=Qm(i);let e="THREE."+i.shift();if(Ur)Ur("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Ue(...i){i=Qm(i);let e="THREE."+i.shift();if(Ur)Ur("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Uo(...i){let e=i.join(" ");e in kp||(kp[e]=!0,Ie(...i))}function eg(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var tg={[Ul]:Ul,[Ol]:zl,[Bl]:Bl,[Nr]:kl,[Fl]:Fl,[zl]:Ol,[Gl]:Gl,[kl]:Nr},Mi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},un=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],zp=1234567,Pr=Math.PI/180,Fr=180/Math.PI;function ws(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(un[i&255]+un[i>>8&255]+un[i>>16&255]+un[i>>24&255]+"-"+un[e&255]+un[e>>8&255]+"-"+un[e>>16&15|64]+un[e>>24&255]+"-"+un[t&63|128]+un[t>>8&255]+"-"+un[t>>16&255]+un[t>>24&255]+un[n&255]+un[n>>8&255]+un[n>>16&255]+un[n>>24&255]).toLowerCase()}function Ve(i,e,t){return Math.max(e,Math.min(t,i))}function Ld(i,e){return(i%e+e)%e}function vv(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function Mv(i,e,t){return i!==e?(t-i)/(e-i):0}function Fo(i,e,t){return(1-t)*i+t*e}function bv(i,e,t,n){return Fo(i,e,1-Math.exp(-t*n))}function Sv(i,e=1){return e-Math.abs(Ld(i,e*2)-e)}function wv(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function Av(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function Ev(i,e){return i+Math.floor(Math.random()*(e-i+1))}function Tv(i,e){return i+Math.random()*(e-i)}function Rv(i){return i*(.5-Math.random())}function Cv(i){i!==void 0&&(zp=i);let e=zp+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Iv(i){return i*Pr}function Pv(i){return i*Fr}function Lv(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Nv(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Nd(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Dv(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),u=o((e+n)/2),h=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),p=o((n-e)/2);switch(s){case"XYX":i.set(a*u,l*h,l*d,a*c);break;case"YZY":i.set(l*d,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*d,a*u,a*c);break;case"XZX":i.set(a*u,l*p,l*f,a*c);break;case"YXY":i.set(l*f,a*u,l*p,a*c);break;case"ZYZ":i.set(l*p,l*f,a*u,a*c);break;default:Ie("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Qc(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Dd(i,e){if(e.constructor===Float32Array)return i;let t=Qc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Ud(i,e){if(e.constructor===Float32Array)return i;let t=Qc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var eu={DEG2RAD:Pr,RAD2DEG:Fr,generateUUID:ws,clamp:Ve,euclideanModulo:Ld,mapLinear:vv,inverseLerp:Mv,lerp:Fo,damp:bv,pingpong:Sv,smoothstep:wv,smootherstep:Av,randInt:Ev,randFloat:Tv,randFloatSpread:Rv,seededRandom:Cv,degToRad:Iv,radToDeg:Pv,isPowerOfTwo:Lv,ceilPowerOfTwo:Nv,floorPowerOfTwo:Nd,setQuaternionFromProperEuler:Dv,normalize:Ud,denormalize:Dd},Ge=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Ve(this.x,e.x,t.x),this.y=Ve(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Ve(this.x,e,t),this.y=Ve(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ve(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Ve(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ot=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],g=r[o+3];if(h!==g||l!==d||c!==f||u!==p){let m=l*d+c*f+u*p+h*g;m<0&&(d=-d,f=-f,p=-p,g=-g,m=-m);let x=1-a;if(m<.9995){let y=Math.acos(m),v=Math.sin(y);x=Math.sin(x*y)/v,a=Math.sin(a*y)/v,l=l*x+d*a,c=c*x+f*a,u=u*x+p*a,h=h*x+g*a}else{l=l*x+d*a,c=c*x+f*a,u=u*x+p*a,h=h*x+g*a;let y=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=y,c*=y,u*=y,h*=y}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+u*h+l*f-c*d,e[t+1]=l*p+u*d+c*h-a*f,e[t+2]=c*p+u*f+a*d-l*h,e[t+3]=u*p-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),d=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:Ie("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=n+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>h){let f=2*Math.sqrt(1+n-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-n-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Ve(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},C=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Gp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Gp.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Ve(this.x,e.x,t.x),this.y=Ve(this.y,e.y,t.y),this.z=Ve(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Ve(this.x,e,t),this.y=Ve(this.y,e,t),this.z=Ve(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ve(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Ih.copy(this).projectOnVector(e),this.sub(Ih)}reflect(e){return this.sub(Ih.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Ve(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ih=new C,Gp=new ot,Oe=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],d=n[2],f=n[5],p=n[8],g=s[0],m=s[3],x=s[6],y=s[1],v=s[4],M=s[7],w=s[2],A=s[5],_=s[8];return r[0]=o*g+a*y+l*w,r[3]=o*m+a*v+l*A,r[6]=o*x+a*M+l*_,r[1]=c*g+u*y+h*w,r[4]=c*m+u*v+h*A,r[7]=c*x+u*M+h*_,r[2]=d*g+f*y+p*w,r[5]=d*m+f*v+p*A,r[8]=d*x+f*M+p*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=t*h+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let g=1/p;return e[0]=h*g,e[1]=(s*c-u*n)*g,e[2]=(a*n-s*o)*g,e[3]=d*g,e[4]=(u*t-s*l)*g,e[5]=(s*r-a*t)*g,e[6]=f*g,e[7]=(n*l-c*t)*g,e[8]=(o*t-n*r)*g,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Uo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ph.makeScale(e,t)),this}rotate(e){return Uo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ph.makeRotation(-e)),this}translate(e,t){return Uo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ph.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Ph=new Oe,Vp=new Oe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Hp=new Oe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Uv(){let i={enabled:!0,workingColorSpace:Bo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===rt&&(s.r=Wi(s.r),s.g=Wi(s.g),s.b=Wi(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===rt&&(s.r=Lr(s.r),s.g=Lr(s.g),s.b=Lr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ji?ko:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Bo]:{primaries:e,whitePoint:n,transfer:ko,toXYZ:Vp,fromXYZ:Hp,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Un},outputColorSpaceConfig:{drawingBufferColorSpace:Un}},[Un]:{primaries:e,whitePoint:n,transfer:rt,toXYZ:Vp,fromXYZ:Hp,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Un}}}),i}var Ke=Uv();function Wi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Lr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var mr,ql=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{mr===void 0&&(mr=zo("canvas")),mr.width=e.width,mr.height=e.height;let s=mr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=mr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=zo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Wi(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Wi(t[n]/255)*255):t[n]=Wi(t[n]);return{data:t,width:e.width,height:e.height}}else return Ie("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Fv=0,Or=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Fv++}),this.uuid=ws(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Lh(s[o].image)):r.push(Lh(s[o]))}else r=Lh(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Lh(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ql.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ie("Texture: Unable to serialize Texture."),{})}var Ov=0,Nh=new C,Rn=class i extends Mi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=vi,s=vi,r=Ft,o=Yi,a=di,l=In,c=i.DEFAULT_ANISOTROPY,u=ji){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Ov++}),this.uuid=ws(),this.name="",this.source=new Or(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ge(0,0),this.repeat=new Ge(1,1),this.center=new Ge(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Oe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Nh).x}get height(){return this.source.getSize(Nh).y}get depth(){return this.source.getSize(Nh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ie(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ie(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==vd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Vl:e.x=e.x-Math.floor(e.x);break;case vi:e.x=e.x<0?0:1;break;case Hl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Vl:e.y=e.y-Math.floor(e.y);break;case vi:e.y=e.y<0?0:1;break;case Hl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Rn.DEFAULT_IMAGE=null;Rn.DEFAULT_MAPPING=vd;Rn.DEFAULT_ANISOTROPY=1;var at=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],g=l[2],m=l[6],x=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-g)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+g)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+x-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let v=(c+1)/2,M=(f+1)/2,w=(x+1)/2,A=(u+d)/4,_=(h+g)/4,b=(p+m)/4;return v>M&&v>w?v<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(v),s=A/n,r=_/n):M>w?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=A/s,r=b/s):w<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(w),n=_/r,s=b/r),this.set(n,s,r,t),this}let y=Math.sqrt((m-p)*(m-p)+(h-g)*(h-g)+(d-u)*(d-u));return Math.abs(y)<.001&&(y=1),this.x=(m-p)/y,this.y=(h-g)/y,this.z=(d-u)/y,this.w=Math.acos((c+f+x-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Ve(this.x,e.x,t.x),this.y=Ve(this.y,e.y,t.y),this.z=Ve(this.z,e.z,t.z),this.w=Ve(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Ve(this.x,e,t),this.y=Ve(this.y,e,t),this.z=Ve(this.z,e,t),this.w=Ve(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ve(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Xl=class extends Mi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ft,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new at(0,0,e,t),this.scissorTest=!1,this.viewport=new at(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Rn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Ft,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Or(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Fn=class extends Xl{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Vo=class extends Rn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=qt,this.minFilter=qt,this.wrapR=vi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var $l=class extends Rn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=qt,this.minFilter=qt,this.wrapR=vi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Qe=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,u,h,d,f,p,g,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,h,d,f,p,g,m)}set(e,t,n,s,r,o,a,l,c,u,h,d,f,p,g,m){let x=this.elements;return x[0]=e,x[4]=t,x[8]=n,x[12]=s,x[1]=r,x[5]=o,x[9]=a,x[13]=l,x[2]=c,x[6]=u,x[10]=h,x[14]=d,x[3]=f,x[7]=p,x[11]=g,x[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/gr.setFromMatrixColumn(e,0).length(),r=1/gr.setFromMatrixColumn(e,1).length(),o=1/gr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,p=a*u,g=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+p*c,t[5]=d-g*c,t[9]=-a*l,t[2]=g-d*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,p=c*u,g=c*h;t[0]=d+g*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-p,t[6]=g+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,p=c*u,g=c*h;t[0]=d-g*a,t[4]=-o*h,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*u,t[9]=g-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,p=a*u,g=a*h;t[0]=l*u,t[4]=p*c-f,t[8]=d*c+g,t[1]=l*h,t[5]=g*c+d,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,p=a*l,g=a*c;t[0]=l*u,t[4]=g-d*h,t[8]=p*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+p,t[10]=d-g*h}else if(e.order==="XZY"){let d=o*l,f=o*c,p=a*l,g=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+g,t[5]=o*u,t[9]=f*h-p,t[2]=p*h-f,t[6]=a*u,t[10]=g*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Bv,e,kv)}lookAt(e,t,n){let s=this.elements;return Nn.subVectors(e,t),Nn.lengthSq()===0&&(Nn.z=1),Nn.normalize(),us.crossVectors(n,Nn),us.lengthSq()===0&&(Math.abs(n.z)===1?Nn.x+=1e-4:Nn.z+=1e-4,Nn.normalize(),us.crossVectors(n,Nn)),us.normalize(),sl.crossVectors(Nn,us),s[0]=us.x,s[4]=sl.x,s[8]=Nn.x,s[1]=us.y,s[5]=sl.y,s[9]=Nn.y,s[2]=us.z,s[6]=sl.z,s[10]=Nn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],d=n[9],f=n[13],p=n[2],g=n[6],m=n[10],x=n[14],y=n[3],v=n[7],M=n[11],w=n[15],A=s[0],_=s[4],b=s[8],I=s[12],T=s[1],L=s[5],D=s[9],O=s[13],P=s[2],B=s[6],H=s[10],V=s[14],ee=s[3],X=s[7],j=s[11],te=s[15];return r[0]=o*A+a*T+l*P+c*ee,r[4]=o*_+a*L+l*B+c*X,r[8]=o*b+a*D+l*H+c*j,r[12]=o*I+a*O+l*V+c*te,r[1]=u*A+h*T+d*P+f*ee,r[5]=u*_+h*L+d*B+f*X,r[9]=u*b+h*D+d*H+f*j,r[13]=u*I+h*O+d*V+f*te,r[2]=p*A+g*T+m*P+x*ee,r[6]=p*_+g*L+m*B+x*X,r[10]=p*b+g*D+m*H+x*j,r[14]=p*I+g*O+m*V+x*te,r[3]=y*A+v*T+M*P+w*ee,r[7]=y*_+v*L+M*B+w*X,r[11]=y*b+v*D+M*H+w*j,r[15]=y*I+v*O+M*V+w*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],p=e[3],g=e[7],m=e[11],x=e[15],y=l*f-c*d,v=a*f-c*h,M=a*d-l*h,w=o*f-c*u,A=o*d-l*u,_=o*h-a*u;return t*(g*y-m*v+x*M)-n*(p*y-m*w+x*A)+s*(p*v-g*w+x*_)-r*(p*M-g*A+m*_)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-n*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],p=e[12],g=e[13],m=e[14],x=e[15],y=t*a-n*o,v=t*l-s*o,M=t*c-r*o,w=n*l-s*a,A=n*c-r*a,_=s*c-r*l,b=u*g-h*p,I=u*m-d*p,T=u*x-f*p,L=h*m-d*g,D=h*x-f*g,O=d*x-f*m,P=y*O-v*D+M*L+w*T-A*I+_*b;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let B=1/P;return e[0]=(a*O-l*D+c*L)*B,e[1]=(s*D-n*O-r*L)*B,e[2]=(g*_-m*A+x*w)*B,e[3]=(d*A-h*_-f*w)*B,e[4]=(l*T-o*O-c*I)*B,e[5]=(t*O-s*T+r*I)*B,e[6]=(m*M-p*_-x*v)*B,e[7]=(u*_-d*M+f*v)*B,e[8]=(o*D-a*T+c*b)*B,e[9]=(n*T-t*D-r*b)*B,e[10]=(p*A-g*M+x*y)*B,e[11]=(h*M-u*A-f*y)*B,e[12]=(a*I-o*L-l*b)*B,e[13]=(t*L-n*I+s*b)*B,e[14]=(g*v-p*w-m*y)*B,e[15]=(u*w-h*v+d*y)*B,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,g=o*u,m=o*h,x=a*h,y=l*c,v=l*u,M=l*h,w=n.x,A=n.y,_=n.z;return s[0]=(1-(g+x))*w,s[1]=(f+M)*w,s[2]=(p-v)*w,s[3]=0,s[4]=(f-M)*A,s[5]=(1-(d+x))*A,s[6]=(m+y)*A,s[7]=0,s[8]=(p+v)*_,s[9]=(m-y)*_,s[10]=(1-(d+g))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=gr.set(s[0],s[1],s[2]).length(),a=gr.set(s[4],s[5],s[6]).length(),l=gr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),si.copy(this);let c=1/o,u=1/a,h=1/l;return si.elements[0]*=c,si.elements[1]*=c,si.elements[2]*=c,si.elements[4]*=u,si.elements[5]*=u,si.elements[6]*=u,si.elements[8]*=h,si.elements[9]*=h,si.elements[10]*=h,t.setFromRotationMatrix(si),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=jn,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),p,g;if(l)p=r/(o-r),g=o*r/(o-r);else if(a===jn)p=-(o+r)/(o-r),g=-2*o*r/(o-r);else if(a===Dr)p=-o/(o-r),g=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=g,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=jn,l=!1){let c=this.elements,u=2/(t-e),h=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),p,g;if(l)p=1/(o-r),g=o/(o-r);else if(a===jn)p=-2/(o-r),g=-(o+r)/(o-r);else if(a===Dr)p=-1/(o-r),g=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=g,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},gr=new C,si=new Qe,Bv=new C(0,0,0),kv=new C(1,1,1),us=new C,sl=new C,Nn=new C,Wp=new Qe,qp=new ot,bi=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(Ve(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ve(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ve(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ve(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Ve(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ve(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Ie("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Wp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Wp,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return qp.setFromEuler(this),this.setFromQuaternion(qp,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};bi.DEFAULT_ORDER="XYZ";var Ho=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},zv=0,Xp=new C,xr=new ot,Bi=new Qe,rl=new C,Ro=new C,Gv=new C,Vv=new ot,$p=new C(1,0,0),Yp=new C(0,1,0),Zp=new C(0,0,1),jp={type:"added"},Hv={type:"removed"},yr={type:"childadded",child:null},Dh={type:"childremoved",child:null},en=class i extends Mi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:zv++}),this.uuid=ws(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new C,t=new bi,n=new ot,s=new C(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Qe},normalMatrix:{value:new Oe}}),this.matrix=new Qe,this.matrixWorld=new Qe,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ho,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return xr.setFromAxisAngle(e,t),this.quaternion.multiply(xr),this}rotateOnWorldAxis(e,t){return xr.setFromAxisAngle(e,t),this.quaternion.premultiply(xr),this}rotateX(e){return this.rotateOnAxis($p,e)}rotateY(e){return this.rotateOnAxis(Yp,e)}rotateZ(e){return this.rotateOnAxis(Zp,e)}translateOnAxis(e,t){return Xp.copy(e).applyQuaternion(this.quaternion),this.position.add(Xp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis($p,e)}translateY(e){return this.translateOnAxis(Yp,e)}translateZ(e){return this.translateOnAxis(Zp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Bi.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?rl.copy(e):rl.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ro.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Bi.lookAt(Ro,rl,this.up):Bi.lookAt(rl,Ro,this.up),this.quaternion.setFromRotationMatrix(Bi),s&&(Bi.extractRotation(s.matrixWorld),xr.setFromRotationMatrix(Bi),this.quaternion.premultiply(xr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Ue("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(jp),yr.child=e,this.dispatchEvent(yr),yr.child=null):Ue("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Hv),Dh.child=e,this.dispatchEvent(Dh),Dh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Bi.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Bi.multiply(e.parent.matrixWorld)),e.applyMatrix4(Bi),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(jp),yr.child=e,this.dispatchEvent(yr),yr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ro,e,Gv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ro,Vv,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};en.DEFAULT_UP=new C(0,1,0);en.DEFAULT_MATRIX_AUTO_UPDATE=!0;en.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ut=class extends en{constructor(){super(),this.isGroup=!0,this.type="Group"}},Wv={type:"move"},Br=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ut,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ut,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new C,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new C),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ut,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new C,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new C,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let g of e.hand.values()){let m=t.getJointPose(g,n),x=this._getHandJoint(c,g);m!==null&&(x.matrix.fromArray(m.transform.matrix),x.matrix.decompose(x.position,x.quaternion,x.scale),x.matrixWorldNeedsUpdate=!0,x.jointRadius=m.radius),x.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Wv)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new ut;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},ng={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},hs={h:0,s:0,l:0},ol={h:0,s:0,l:0};function Uh(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Fe=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Un){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Ke.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=Ke.workingColorSpace){return this.r=e,this.g=t,this.b=n,Ke.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=Ke.workingColorSpace){if(e=Ld(e,1),t=Ve(t,0,1),n=Ve(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Uh(o,r,e+1/3),this.g=Uh(o,r,e),this.b=Uh(o,r,e-1/3)}return Ke.colorSpaceToWorking(this,s),this}setStyle(e,t=Un){function n(r){r!==void 0&&parseFloat(r)<1&&Ie("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ie("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ie("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Un){let n=ng[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ie("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Wi(e.r),this.g=Wi(e.g),this.b=Wi(e.b),this}copyLinearToSRGB(e){return this.r=Lr(e.r),this.g=Lr(e.g),this.b=Lr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Un){return Ke.workingToColorSpace(hn.copy(this),e),Math.round(Ve(hn.r*255,0,255))*65536+Math.round(Ve(hn.g*255,0,255))*256+Math.round(Ve(hn.b*255,0,255))}getHexString(e=Un){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Ke.workingColorSpace){Ke.workingToColorSpace(hn.copy(this),t);let n=hn.r,s=hn.g,r=hn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=Ke.workingColorSpace){return Ke.workingToColorSpace(hn.copy(this),t),e.r=hn.r,e.g=hn.g,e.b=hn.b,e}getStyle(e=Un){Ke.workingToColorSpace(hn.copy(this),e);let t=hn.r,n=hn.g,s=hn.b;return e!==Un?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(hs),this.setHSL(hs.h+e,hs.s+t,hs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(hs),e.getHSL(ol);let n=Fo(hs.h,ol.h,t),s=Fo(hs.s,ol.s,t),r=Fo(hs.l,ol.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},hn=new Fe;Fe.NAMES=ng;var Wo=class extends en{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new bi,this.environmentIntensity=1,this.environmentRotation=new bi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},ri=new C,ki=new C,Fh=new C,zi=new C,_r=new C,vr=new C,Kp=new C,Oh=new C,Bh=new C,kh=new C,zh=new at,Gh=new at,Vh=new at,Hi=class i{constructor(e=new C,t=new C,n=new C){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),ri.subVectors(e,t),s.cross(ri);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){ri.subVectors(s,t),ki.subVectors(n,t),Fh.subVectors(e,t);let o=ri.dot(ri),a=ri.dot(ki),l=ri.dot(Fh),c=ki.dot(ki),u=ki.dot(Fh),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,zi)===null?!1:zi.x>=0&&zi.y>=0&&zi.x+zi.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,zi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,zi.x),l.addScaledVector(o,zi.y),l.addScaledVector(a,zi.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return zh.setScalar(0),Gh.setScalar(0),Vh.setScalar(0),zh.fromBufferAttribute(e,t),Gh.fromBufferAttribute(e,n),Vh.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(zh,r.x),o.addScaledVector(Gh,r.y),o.addScaledVector(Vh,r.z),o}static isFrontFacing(e,t,n,s){return ri.subVectors(n,t),ki.subVectors(e,t),ri.cross(ki).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ri.subVectors(this.c,this.b),ki.subVectors(this.a,this.b),ri.cross(ki).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;_r.subVectors(s,n),vr.subVectors(r,n),Oh.subVectors(e,n);let l=_r.dot(Oh),c=vr.dot(Oh);if(l<=0&&c<=0)return t.copy(n);Bh.subVectors(e,s);let u=_r.dot(Bh),h=vr.dot(Bh);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(n).addScaledVector(_r,o);kh.subVectors(e,r);let f=_r.dot(kh),p=vr.dot(kh);if(p>=0&&f<=p)return t.copy(r);let g=f*c-l*p;if(g<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(n).addScaledVector(vr,a);let m=u*p-f*h;if(m<=0&&h-u>=0&&f-p>=0)return Kp.subVectors(r,s),a=(h-u)/(h-u+(f-p)),t.copy(s).addScaledVector(Kp,a);let x=1/(m+g+d);return o=g*x,a=d*x,t.copy(n).addScaledVector(_r,o).addScaledVector(vr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},yn=class{constructor(e=new C(1/0,1/0,1/0),t=new C(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(oi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(oi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=oi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,oi):oi.fromBufferAttribute(r,o),oi.applyMatrix4(e.matrixWorld),this.expandByPoint(oi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),al.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),al.copy(n.boundingBox)),al.applyMatrix4(e.matrixWorld),this.union(al)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,oi),oi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Co),ll.subVectors(this.max,Co),Mr.subVectors(e.a,Co),br.subVectors(e.b,Co),Sr.subVectors(e.c,Co),ds.subVectors(br,Mr),fs.subVectors(Sr,br),Ys.subVectors(Mr,Sr);let t=[0,-ds.z,ds.y,0,-fs.z,fs.y,0,-Ys.z,Ys.y,ds.z,0,-ds.x,fs.z,0,-fs.x,Ys.z,0,-Ys.x,-ds.y,ds.x,0,-fs.y,fs.x,0,-Ys.y,Ys.x,0];return!Hh(t,Mr,br,Sr,ll)||(t=[1,0,0,0,1,0,0,0,1],!Hh(t,Mr,br,Sr,ll))?!1:(cl.crossVectors(ds,fs),t=[cl.x,cl.y,cl.z],Hh(t,Mr,br,Sr,ll))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,oi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(oi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Gi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Gi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Gi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Gi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Gi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Gi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Gi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Gi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Gi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Gi=[new C,new C,new C,new C,new C,new C,new C,new C],oi=new C,al=new yn,Mr=new C,br=new C,Sr=new C,ds=new C,fs=new C,Ys=new C,Co=new C,ll=new C,cl=new C,Zs=new C;function Hh(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Zs.fromArray(i,r);let a=s.x*Math.abs(Zs.x)+s.y*Math.abs(Zs.y)+s.z*Math.abs(Zs.z),l=e.dot(Zs),c=t.dot(Zs),u=n.dot(Zs);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Nt=new C,ul=new Ge,qv=0,Ct=class extends Mi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:qv++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Id,this.updateRanges=[],this.gpuType=ei,this.version=0,this._normalizationScale=e!==void 0?Qc(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)ul.fromBufferAttribute(this,t),ul.applyMatrix3(e),this.setXY(t,ul.x,ul.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Nt.fromBufferAttribute(this,t),Nt.applyMatrix3(e),this.setXYZ(t,Nt.x,Nt.y,Nt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Nt.fromBufferAttribute(this,t),Nt.applyMatrix4(e),this.setXYZ(t,Nt.x,Nt.y,Nt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Nt.fromBufferAttribute(this,t),Nt.applyNormalMatrix(e),this.setXYZ(t,Nt.x,Nt.y,Nt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Nt.fromBufferAttribute(this,t),Nt.transformDirection(e),this.setXYZ(t,Nt.x,Nt.y,Nt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Dd(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Ud(e,this.array)}};var qo=class extends Ct{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Xo=class extends Ct{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var tt=class extends Ct{constructor(e,t,n){super(new Float32Array(e),t,n)}},Xv=new yn,Io=new C,Wh=new C,Cn=class{constructor(e=new C,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Xv.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Io.subVectors(e,this.center);let t=Io.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Io,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Wh.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Io.copy(e.center).add(Wh)),this.expandByPoint(Io.copy(e.center).sub(Wh))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},$v=0,Zn=new Qe,qh=new en,wr=new C,Dn=new yn,Po=new yn,Wt=new C,xt=class i extends Mi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:$v++}),this.uuid=ws(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(yv(e)?Xo:qo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Oe().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Zn.makeRotationFromQuaternion(e),this.applyMatrix4(Zn),this}rotateX(e){return Zn.makeRotationX(e),this.applyMatrix4(Zn),this}rotateY(e){return Zn.makeRotationY(e),this.applyMatrix4(Zn),this}rotateZ(e){return Zn.makeRotationZ(e),this.applyMatrix4(Zn),this}translate(e,t,n){return Zn.makeTranslation(e,t,n),this.applyMatrix4(Zn),this}scale(e,t,n){return Zn.makeScale(e,t,n),this.applyMatrix4(Zn),this}lookAt(e){return qh.lookAt(e),qh.updateMatrix(),this.applyMatrix4(qh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(wr).negate(),this.translate(wr.x,wr.y,wr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new tt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ie("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new yn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ue("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new C(-1/0,-1/0,-1/0),new C(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];Dn.setFromBufferAttribute(r),this.morphTargetsRelative?(Wt.addVectors(this.boundingBox.min,Dn.min),this.boundingBox.expandByPoint(Wt),Wt.addVectors(this.boundingBox.max,Dn.max),this.boundingBox.expandByPoint(Wt)):(this.boundingBox.expandByPoint(Dn.min),this.boundingBox.expandByPoint(Dn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ue('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Cn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ue("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new C,1/0);return}if(e){let n=this.boundingSphere.center;if(Dn.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Po.setFromBufferAttribute(a),this.morphTargetsRelative?(Wt.addVectors(Dn.min,Po.min),Dn.expandByPoint(Wt),Wt.addVectors(Dn.max,Po.max),Dn.expandByPoint(Wt)):(Dn.expandByPoint(Po.min),Dn.expandByPoint(Po.max))}Dn.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Wt.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Wt));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Wt.fromBufferAttribute(a,c),l&&(wr.fromBufferAttribute(e,c),Wt.add(wr)),s=Math.max(s,n.distanceToSquared(Wt))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ue('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Ue("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Ct(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let I=0;I<n.count;I++)a[I]=new C,l[I]=new C;let u=new C,h=new C,d=new C,f=new Ge,p=new Ge,g=new Ge,m=new C,x=new C;function y(I,T,L){c[I]=c[T]=c[L]=1,u.fromBufferAttribute(n,I),h.fromBufferAttribute(n,T),d.fromBufferAttribute(n,L),f.fromBufferAttribute(r,I),p.fromBufferAttribute(r,T),g.fromBufferAttribute(r,L),h.sub(u),d.sub(u),p.sub(f),g.sub(f);let D=1/(p.x*g.y-g.x*p.y);isFinite(D)&&(m.copy(h).multiplyScalar(g.y).addScaledVector(d,-p.y).multiplyScalar(D),x.copy(d).multiplyScalar(p.x).addScaledVector(h,-g.x).multiplyScalar(D),a[I].add(m),a[T].add(m),a[L].add(m),l[I].add(x),l[T].add(x),l[L].add(x))}let v=this.groups;v.length===0&&(v=[{start:0,count:e.count}]);for(let I=0,T=v.length;I<T;++I){let L=v[I],D=L.start,O=L.count;for(let P=D,B=D+O;P<B;P+=3)y(e.getX(P+0),e.getX(P+1),e.getX(P+2))}let M=new C,w=new C,A=new C,_=new C;function b(I){A.fromBufferAttribute(s,I),_.copy(A);let T=a[I];M.copy(T),M.sub(A.multiplyScalar(A.dot(T))).normalize(),w.crossVectors(_,T);let D=w.dot(l[I])<0?-1:1;o.setXYZW(I,M.x,M.y,M.z,D)}for(let I=0,T=n.count;I<T;++I)c[I]&&b(I);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Ct(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new C,r=new C,o=new C,a=new C,l=new C,c=new C,u=new C,h=new C;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),g=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,g),o.fromBufferAttribute(t,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,g),c.fromBufferAttribute(n,m),a.add(u),l.add(u),c.add(u),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(g,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(d+0,u.x,u.y,u.z),n.setXYZ(d+1,u.x,u.y,u.z),n.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Wt.fromBufferAttribute(e,t),Wt.normalize(),e.setXYZ(t,Wt.x,Wt.y,Wt.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let g=0,m=l.length;g<m;g++){a.isInterleavedBufferAttribute?f=l[g]*a.data.stride+a.offset:f=l[g]*u;for(let x=0;x<u;x++)d[p++]=c[f++]}return new Ct(d,u,h)}if(this.index===null)return Ie("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},$o=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Id,this.updateRanges=[],this.version=0,this.uuid=ws()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Jp(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Jp(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Jp(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=ws()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var gn=new C,Kn=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?Qc(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix4(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.applyNormalMatrix(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.transformDirection(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Go("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new Ct(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Go("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Dd(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Ud(e,this.data.array)}},Xh=new C,Yv=new C,Zv=new Oe,ai=class{constructor(e=new C(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Xh.subVectors(n,t).cross(Yv.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Xh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Zv.getNormalMatrix(e),s=this.coplanarPoint(Xh).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},jv=0,Jn=class extends Mi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:jv++}),this.uuid=ws(),this.name="",this.type="Material",this.blending=Xr,this.side=bs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=hd,this.blendDst=dd,this.blendEquation=tr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Fe(0,0,0),this.blendAlpha=0,this.depthFunc=Nr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Xm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Dl,this.stencilZFail=Dl,this.stencilZPass=Dl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ie(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ie(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Fe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new ai().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ge().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ge().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Vi=new C,$h=new C,hl=new C,dl=new C,kr=class{constructor(e=new C,t=new C(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Vi)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Vi.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Vi.copy(this.origin).addScaledVector(this.direction,t),Vi.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){$h.copy(e).add(t).multiplyScalar(.5),hl.copy(t).sub(e).normalize(),dl.copy(this.origin).sub($h);let r=e.distanceTo(t)*.5,o=-this.direction.dot(hl),a=dl.dot(this.direction),l=-dl.dot(hl),c=dl.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let g=1/u;h*=g,d*=g,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy($h).addScaledVector(hl,d),f}intersectSphere(e,t){if(e.radius<0)return null;Vi.subVectors(e.center,this.origin);let n=Vi.dot(this.direction),s=Vi.dot(Vi)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Vi)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,p=t.x-o.x,g=t.y-o.y,m=t.z-o.z,x=n.x-o.x,y=n.y-o.y,v=n.z-o.z,M=Math.abs(l),w=Math.abs(c),A=Math.abs(u),_,b,I,T,L,D,O,P,B,H,V,ee;if(M>=w&&M>=A?(I=l,D=h,B=p,ee=x,l>=0?(_=c,b=u,T=d,L=f,O=g,P=m,H=y,V=v):(_=u,b=c,T=f,L=d,O=m,P=g,H=v,V=y)):w>=A?(I=c,D=d,B=g,ee=y,c>=0?(_=u,b=l,T=f,L=h,O=m,P=p,H=v,V=x):(_=l,b=u,T=h,L=f,O=p,P=m,H=x,V=v)):(I=u,D=f,B=m,ee=v,u>=0?(_=l,b=c,T=h,L=d,O=p,P=g,H=x,V=y):(_=c,b=l,T=d,L=h,O=g,P=p,H=y,V=x)),I===0)return null;let X=_/I,j=b/I,te=1/I,ve=T-X*D,Pe=L-j*D,Y=O-X*B,ge=P-j*B,Me=H-X*ee,Le=V-j*ee,ye=Me*ge-Le*Y,ze=ve*Le-Pe*Me,Pt=Y*Pe-ge*ve;if(s){if(ye<0||ze<0||Pt<0)return null}else if((ye<0||ze<0||Pt<0)&&(ye>0||ze>0||Pt>0))return null;let De=ye+ze+Pt;if(De===0)return null;let lt=te*(ye*D+ze*B+Pt*ee);return(De>0?lt<0:lt>0)?null:this.at(lt/De,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},dn=class extends Jn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Fe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new bi,this.combine=fa,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Qp=new Qe,js=new kr,fl=new Cn,em=new C,pl=new C,ml=new C,gl=new C,Yh=new C,xl=new C,tm=new C,yl=new C,$e=class extends en{constructor(e=new xt,t=new dn){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){xl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Yh.fromBufferAttribute(h,e),o?xl.addScaledVector(Yh,u):xl.addScaledVector(Yh.sub(t),u))}t.add(xl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),fl.copy(n.boundingSphere),fl.applyMatrix4(r),js.copy(e.ray).recast(e.near),!(fl.containsPoint(js.origin)===!1&&(js.intersectSphere(fl,em)===null||js.origin.distanceToSquared(em)>(e.far-e.near)**2))&&(Qp.copy(r).invert(),js.copy(e.ray).applyMatrix4(Qp),!(n.boundingBox!==null&&js.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,js)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,g=d.length;p<g;p++){let m=d[p],x=o[m.materialIndex],y=Math.max(m.start,f.start),v=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let M=y,w=v;M<w;M+=3){let A=a.getX(M),_=a.getX(M+1),b=a.getX(M+2);s=_l(this,x,e,n,c,u,h,A,_,b),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),g=Math.min(a.count,f.start+f.count);for(let m=p,x=g;m<x;m+=3){let y=a.getX(m),v=a.getX(m+1),M=a.getX(m+2);s=_l(this,o,e,n,c,u,h,y,v,M),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,g=d.length;p<g;p++){let m=d[p],x=o[m.materialIndex],y=Math.max(m.start,f.start),v=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let M=y,w=v;M<w;M+=3){let A=M,_=M+1,b=M+2;s=_l(this,x,e,n,c,u,h,A,_,b),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),g=Math.min(l.count,f.start+f.count);for(let m=p,x=g;m<x;m+=3){let y=m,v=m+1,M=m+2;s=_l(this,o,e,n,c,u,h,y,v,M),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Kv(i,e,t,n,s,r,o,a){let l;if(e.side===vn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===bs,a),l===null)return null;yl.copy(a),yl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(yl);return c<t.near||c>t.far?null:{distance:c,point:yl.clone(),object:i}}function _l(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,pl),i.getVertexPosition(l,ml),i.getVertexPosition(c,gl);let u=Kv(i,e,t,n,pl,ml,gl,tm);if(u){let h=new C;Hi.getBarycoord(tm,pl,ml,gl,h),s&&(u.uv=Hi.getInterpolatedAttribute(s,a,l,c,h,new Ge)),r&&(u.uv1=Hi.getInterpolatedAttribute(r,a,l,c,h,new Ge)),o&&(u.normal=Hi.getInterpolatedAttribute(o,a,l,c,h,new C),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new C,materialIndex:0};Hi.getNormal(pl,ml,gl,d.normal),u.face=d,u.barycoord=h}return u}var li=class extends Rn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=qt,u=qt,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var zr=class extends Ct{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Ar=new Qe,nm=new Qe,vl=[],im=new yn,Jv=new Qe,Lo=new $e,No=new Cn,Yo=class extends $e{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new zr(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Jv)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new yn),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Ar),im.copy(e.boundingBox).applyMatrix4(Ar),this.boundingBox.union(im)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Cn),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Ar),No.copy(e.boundingSphere).applyMatrix4(Ar),this.boundingSphere.union(No)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(Lo.geometry=this.geometry,Lo.material=this.material,Lo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),No.copy(this.boundingSphere),No.applyMatrix4(n),e.ray.intersectsSphere(No)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Ar),nm.multiplyMatrices(n,Ar),Lo.matrixWorld=nm,Lo.raycast(e,vl);for(let o=0,a=vl.length;o<a;o++){let l=vl[o];l.instanceId=r,l.object=this,t.push(l)}vl.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new zr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new li(new Float32Array(s*this.count),s,this.count,_c,ei));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Ks=new Cn,Qv=new Ge(.5,.5),Ml=new C,ms=class{constructor(e=new ai,t=new ai,n=new ai,s=new ai,r=new ai,o=new ai){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=jn,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],g=r[9],m=r[10],x=r[11],y=r[12],v=r[13],M=r[14],w=r[15];if(s[0].setComponents(c-o,f-u,x-p,w-y).normalize(),s[1].setComponents(c+o,f+u,x+p,w+y).normalize(),s[2].setComponents(c+a,f+h,x+g,w+v).normalize(),s[3].setComponents(c-a,f-h,x-g,w-v).normalize(),n)s[4].setComponents(l,d,m,M).normalize(),s[5].setComponents(c-l,f-d,x-m,w-M).normalize();else if(s[4].setComponents(c-l,f-d,x-m,w-M).normalize(),t===jn)s[5].setComponents(c+l,f+d,x+m,w+M).normalize();else if(t===Dr)s[5].setComponents(l,d,m,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Ks.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Ks.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Ks)}intersectsSprite(e){Ks.center.set(0,0,0);let t=Qv.distanceTo(e.center);return Ks.radius=.7071067811865476+t,Ks.applyMatrix4(e.matrixWorld),this.intersectsSphere(Ks)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Ml.x=s.normal.x>0?e.max.x:e.min.x,Ml.y=s.normal.y>0?e.max.y:e.min.y,Ml.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Ml)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},sm=new Qe,Yl=class i{constructor(){this.coordinateSystem=jn,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];sm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new ms),n[s].setFromProjectionMatrix(sm,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new ms),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var gs=class extends Jn{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Fe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Zl=new C,jl=new C,rm=new Qe,Do=new kr,bl=new Cn,Zh=new C,om=new C,Gr=class extends en{constructor(e=new xt,t=new gs){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Zl.fromBufferAttribute(t,s-1),jl.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Zl.distanceTo(jl);e.setAttribute("lineDistance",new tt(n,1))}else Ie("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),bl.copy(n.boundingSphere),bl.applyMatrix4(s),bl.radius+=r,e.ray.intersectsSphere(bl)===!1)return;rm.copy(s).invert(),Do.copy(e.ray).applyMatrix4(rm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,d=n.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let g=f,m=p-1;g<m;g+=c){let x=u.getX(g),y=u.getX(g+1),v=Sl(this,e,Do,l,x,y,g);v&&t.push(v)}if(this.isLineLoop){let g=u.getX(p-1),m=u.getX(f),x=Sl(this,e,Do,l,g,m,p-1);x&&t.push(x)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let g=f,m=p-1;g<m;g+=c){let x=Sl(this,e,Do,l,g,g+1,g);x&&t.push(x)}if(this.isLineLoop){let g=Sl(this,e,Do,l,p-1,f,p-1);g&&t.push(g)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Sl(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Zl.fromBufferAttribute(a,s),jl.fromBufferAttribute(a,r),t.distanceSqToSegment(Zl,jl,Zh,om)>n)return;Zh.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Zh);if(!(c<e.near||c>e.far))return{distance:c,point:om.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var am=new C,lm=new C,Js=class extends Gr{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)am.fromBufferAttribute(t,s),lm.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+am.distanceTo(lm);e.setAttribute("lineDistance",new tt(n,1))}else Ie("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Vr=class extends Jn{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Fe(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},cm=new Qe,id=new kr,wl=new Cn,Al=new C,Zo=class extends en{constructor(e=new xt,t=new Vr){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),wl.copy(n.boundingSphere),wl.applyMatrix4(s),wl.radius+=r,e.ray.intersectsSphere(wl)===!1)return;cm.copy(s).invert(),id.copy(e.ray).applyMatrix4(cm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,h=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,g=f;p<g;p++){let m=c.getX(p);Al.fromBufferAttribute(h,m),um(Al,m,l,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let p=d,g=f;p<g;p++)Al.fromBufferAttribute(h,p),um(Al,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function um(i,e,t,n,s,r,o){let a=id.distanceSqToPoint(i);if(a<t){let l=new C;id.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var jo=class extends Rn{constructor(e=[],t=nr,n,s,r,o,a,l,c,u){super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Xi=class extends Rn{constructor(e,t,n=ui,s,r,o,a=qt,l=qt,c,u=qi,h=1){if(u!==qi&&u!==Zi)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Or(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ko=class extends Xi{constructor(e,t=ui,n=nr,s,r,o=qt,a=qt,l,c=qi){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,n,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Jo=class extends Rn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},$i=class i extends xt{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,n,t,e,o,r,0),p("z","y","x",1,-1,n,t,-e,o,r,1),p("x","z","y",1,1,e,n,t,s,o,2),p("x","z","y",1,-1,e,n,-t,s,o,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new tt(c,3)),this.setAttribute("normal",new tt(u,3)),this.setAttribute("uv",new tt(h,2));function p(g,m,x,y,v,M,w,A,_,b,I){let T=M/_,L=w/b,D=M/2,O=w/2,P=A/2,B=_+1,H=b+1,V=0,ee=0,X=new C;for(let j=0;j<H;j++){let te=j*L-O;for(let ve=0;ve<B;ve++){let Pe=ve*T-D;X[g]=Pe*y,X[m]=te*v,X[x]=P,c.push(X.x,X.y,X.z),X[g]=0,X[m]=0,X[x]=A>0?1:-1,u.push(X.x,X.y,X.z),h.push(ve/_),h.push(1-j/b),V+=1}}for(let j=0;j<b;j++)for(let te=0;te<_;te++){let ve=d+te+B*j,Pe=d+te+B*(j+1),Y=d+(te+1)+B*(j+1),ge=d+(te+1)+B*j;l.push(ve,Pe,ge),l.push(Pe,Y,ge),ee+=6}a.addGroup(f,ee,I),f+=ee,d+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var ci=class i extends xt{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,g=[],m=n/2,x=0;y(),o===!1&&(e>0&&v(!0),t>0&&v(!1)),this.setIndex(u),this.setAttribute("position",new tt(h,3)),this.setAttribute("normal",new tt(d,3)),this.setAttribute("uv",new tt(f,2));function y(){let M=new C,w=new C,A=0,_=(t-e)/n;for(let b=0;b<=r;b++){let I=[],T=b/r,L=T*(t-e)+e;for(let D=0;D<=s;D++){let O=D/s,P=O*l+a,B=Math.sin(P),H=Math.cos(P);w.x=L*B,w.y=-T*n+m,w.z=L*H,h.push(w.x,w.y,w.z),M.set(B,_,H).normalize(),d.push(M.x,M.y,M.z),f.push(O,1-T),I.push(p++)}g.push(I)}for(let b=0;b<s;b++)for(let I=0;I<r;I++){let T=g[I][b],L=g[I+1][b],D=g[I+1][b+1],O=g[I][b+1];(e>0||I!==0)&&(u.push(T,L,O),A+=3),(t>0||I!==r-1)&&(u.push(L,D,O),A+=3)}c.addGroup(x,A,0),x+=A}function v(M){let w=p,A=new Ge,_=new C,b=0,I=M===!0?e:t,T=M===!0?1:-1;for(let D=1;D<=s;D++)h.push(0,m*T,0),d.push(0,T,0),f.push(.5,.5),p++;let L=p;for(let D=0;D<=s;D++){let P=D/s*l+a,B=Math.cos(P),H=Math.sin(P);_.x=I*H,_.y=m*T,_.z=I*B,h.push(_.x,_.y,_.z),d.push(0,T,0),A.x=B*.5+.5,A.y=H*.5*T+.5,f.push(A.x,A.y),p++}for(let D=0;D<s;D++){let O=w+D,P=L+D;M===!0?u.push(P,P+1,O):u.push(P+1,P,O),b+=3}c.addGroup(x,b,M===!0?1:2),x+=b}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},xs=class i extends ci{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Kl=class i extends xt{constructor(e=[],t=[],n=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:n,detail:s};let r=[],o=[];a(s),c(n),u(),this.setAttribute("position",new tt(r,3)),this.setAttribute("normal",new tt(r.slice(),3)),this.setAttribute("uv",new tt(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(y){let v=new C,M=new C,w=new C;for(let A=0;A<t.length;A+=3)f(t[A+0],v),f(t[A+1],M),f(t[A+2],w),l(v,M,w,y)}function l(y,v,M,w){let A=w+1,_=[];for(let b=0;b<=A;b++){_[b]=[];let I=y.clone().lerp(M,b/A),T=v.clone().lerp(M,b/A),L=A-b;for(let D=0;D<=L;D++)D===0&&b===A?_[b][D]=I:_[b][D]=I.clone().lerp(T,D/L)}for(let b=0;b<A;b++)for(let I=0;I<2*(A-b)-1;I++){let T=Math.floor(I/2);I%2===0?(d(_[b][T+1]),d(_[b+1][T]),d(_[b][T])):(d(_[b][T+1]),d(_[b+1][T+1]),d(_[b+1][T]))}}function c(y){let v=new C;for(let M=0;M<r.length;M+=3)v.x=r[M+0],v.y=r[M+1],v.z=r[M+2],v.normalize().multiplyScalar(y),r[M+0]=v.x,r[M+1]=v.y,r[M+2]=v.z}function u(){let y=new C;for(let v=0;v<r.length;v+=3){y.x=r[v+0],y.y=r[v+1],y.z=r[v+2];let M=m(y)/2/Math.PI+.5,w=x(y)/Math.PI+.5;o.push(M,1-w)}p(),h()}function h(){for(let y=0;y<o.length;y+=6){let v=o[y+0],M=o[y+2],w=o[y+4],A=Math.max(v,M,w),_=Math.min(v,M,w);A>.9&&_<.1&&(v<.2&&(o[y+0]+=1),M<.2&&(o[y+2]+=1),w<.2&&(o[y+4]+=1))}}function d(y){r.push(y.x,y.y,y.z)}function f(y,v){let M=y*3;v.x=e[M+0],v.y=e[M+1],v.z=e[M+2]}function p(){let y=new C,v=new C,M=new C,w=new C,A=new Ge,_=new Ge,b=new Ge;for(let I=0,T=0;I<r.length;I+=9,T+=6){y.set(r[I+0],r[I+1],r[I+2]),v.set(r[I+3],r[I+4],r[I+5]),M.set(r[I+6],r[I+7],r[I+8]),A.set(o[T+0],o[T+1]),_.set(o[T+2],o[T+3]),b.set(o[T+4],o[T+5]),w.copy(y).add(v).add(M).divideScalar(3);let L=m(w);g(A,T+0,y,L),g(_,T+2,v,L),g(b,T+4,M,L)}}function g(y,v,M,w){w<0&&y.x===1&&(o[v]=y.x-1),M.x===0&&M.z===0&&(o[v]=w/2/Math.PI+.5)}function m(y){return Math.atan2(y.z,-y.x)}function x(y){return Math.atan2(-y.y,Math.sqrt(y.x*y.x+y.z*y.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.vertices,e.indices,e.radius,e.detail)}};var El=new C,Tl=new C,jh=new C,Rl=new Hi,Hr=class extends xt{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(Pr*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),d=new Map,f=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:g,b:m,c:x}=Rl;if(g.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),x.fromBufferAttribute(a,c[2]),Rl.getNormal(jh),h[0]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,h[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,h[2]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let y=0;y<3;y++){let v=(y+1)%3,M=h[y],w=h[v],A=Rl[u[y]],_=Rl[u[v]],b=`${M}_${w}`,I=`${w}_${M}`,T=d.get(I);T?(jh.dot(T.normal)<=r&&(f.push(A.x,A.y,A.z),f.push(_.x,_.y,_.z)),d.set(I,null)):d.has(b)||d.set(b,{index0:c[y],index1:c[v],normal:jh.clone()})}}for(let p of d.values())if(p){let{index0:g,index1:m}=p;El.fromBufferAttribute(a,g),Tl.fromBufferAttribute(a,m),f.push(El.x,El.y,El.z),f.push(Tl.x,Tl.y,Tl.z)}this.setAttribute("position",new tt(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var Qo=class i extends Kl{constructor(e=1,t=0){let n=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(n,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new i(e.radius,e.detail)}},Qs=class i extends xt{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],p=[],g=[],m=[];for(let x=0;x<u;x++){let y=x*d-o;for(let v=0;v<c;v++){let M=v*h-r;p.push(M,-y,0),g.push(0,0,1),m.push(v/a),m.push(1-x/l)}}for(let x=0;x<l;x++)for(let y=0;y<a;y++){let v=y+c*x,M=y+c*(x+1),w=y+1+c*(x+1),A=y+1+c*x;f.push(v,M,A),f.push(M,w,A)}this.setIndex(f),this.setAttribute("position",new tt(p,3)),this.setAttribute("normal",new tt(g,3)),this.setAttribute("uv",new tt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var On=class i extends xt{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new C,d=new C,f=[],p=[],g=[],m=[];for(let x=0;x<=n;x++){let y=[],v=x/n,M=o+v*a,w=e*Math.cos(M),A=Math.sqrt(e*e-w*w),_=0;x===0&&o===0?_=.5/t:x===n&&l===Math.PI&&(_=-.5/t);for(let b=0;b<=t;b++){let I=b/t,T=s+I*r;h.x=-A*Math.cos(T),h.y=w,h.z=A*Math.sin(T),p.push(h.x,h.y,h.z),d.copy(h).normalize(),g.push(d.x,d.y,d.z),m.push(I+_,1-v),y.push(c++)}u.push(y)}for(let x=0;x<n;x++)for(let y=0;y<t;y++){let v=u[x][y+1],M=u[x][y],w=u[x+1][y],A=u[x+1][y+1];(x!==0||o>0)&&f.push(v,M,A),(x!==n-1||l<Math.PI)&&f.push(M,w,A)}this.setIndex(f),this.setAttribute("position",new tt(p,3)),this.setAttribute("normal",new tt(g,3)),this.setAttribute("uv",new tt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var ea=class i extends xt{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new C,f=new C,p=new C;for(let g=0;g<=n;g++){let m=o+g/n*a;for(let x=0;x<=s;x++){let y=x/s*r;f.x=(e+t*Math.cos(m))*Math.cos(y),f.y=(e+t*Math.cos(m))*Math.sin(y),f.z=t*Math.sin(m),c.push(f.x,f.y,f.z),d.x=e*Math.cos(y),d.y=e*Math.sin(y),p.subVectors(f,d).normalize(),u.push(p.x,p.y,p.z),h.push(x/s),h.push(g/n)}}for(let g=1;g<=n;g++)for(let m=1;m<=s;m++){let x=(s+1)*g+m-1,y=(s+1)*(g-1)+m-1,v=(s+1)*(g-1)+m,M=(s+1)*g+m;l.push(x,y,M),l.push(y,v,M)}this.setIndex(l),this.setAttribute("position",new tt(c,3)),this.setAttribute("normal",new tt(u,3)),this.setAttribute("uv",new tt(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};var ta=class extends xt{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new C,r=new C;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],d=h.start,f=h.count;for(let p=d,g=d+f;p<g;p+=3)for(let m=0;m<3;m++){let x=a.getX(p+m),y=a.getX(p+(m+1)%3);s.fromBufferAttribute(o,x),r.fromBufferAttribute(o,y),hm(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,h),hm(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new tt(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function hm(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}function sr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(dm(s))s.isRenderTargetTexture?(Ie("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(dm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function fn(i){let e={};for(let t=0;t<i.length;t++){let n=sr(i[t]);for(let s in n)e[s]=n[s]}return e}function dm(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function eM(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Fd(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Ke.workingColorSpace}var Ma={clone:sr,merge:fn},tM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,nM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Qn=class extends Jn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=tM,this.fragmentShader=nM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=sr(e.uniforms),this.uniformsGroups=eM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Fe().setHex(s.value);break;case"v2":this.uniforms[n].value=new Ge().fromArray(s.value);break;case"v3":this.uniforms[n].value=new C().fromArray(s.value);break;case"v4":this.uniforms[n].value=new at().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Oe().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Qe().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Jl=class extends Qn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var na=class extends Jn{constructor(e){super(),this.isMeshPhongMaterial=!0,this.type="MeshPhongMaterial",this.color=new Fe(16777215),this.specular=new Fe(1118481),this.shininess=30,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Fe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Zr,this.normalScale=new Ge(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new bi,this.combine=fa,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.specular.copy(e.specular),this.shininess=e.shininess,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var _n=class extends Jn{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Fe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Fe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Zr,this.normalScale=new Ge(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new bi,this.combine=fa,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Ql=class extends Jn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Wm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},ec=class extends Jn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}},ia=class extends Jn{constructor(e){super(),this.isMeshMatcapMaterial=!0,this.defines={MATCAP:""},this.type="MeshMatcapMaterial",this.color=new Fe(16777215),this.matcap=null,this.map=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Zr,this.normalScale=new Ge(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.alphaMap=null,this.wireframe=!1,this.wireframeLinewidth=1,this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={MATCAP:""},this.color.copy(e.color),this.matcap=e.matcap,this.map=e.map,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.alphaMap=e.alphaMap,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.flatShading=e.flatShading,this.fog=e.fog,this}};function Er(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Cl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var ys=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},tc=class extends ys{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ed,endingEnd:ed}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case td:r=e,a=2*t-n;break;case nd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case td:o=e,l=2*n-t;break;case nd:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-t)/(s-t),g=p*p,m=g*p,x=-d*m+2*d*g-d*p,y=(1+d)*m+(-1.5-2*d)*g+(-.5+d)*p+1,v=(-1-f)*m+(1.5+f)*g+.5*p,M=f*m-f*g;for(let w=0;w!==a;++w)r[w]=x*o[u+w]+y*o[c+w]+v*o[l+w]+M*o[h+w];return r}},nc=class extends ys{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},ic=class extends ys{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},sc=class extends ys{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(n-t)/(s-t),g=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*g+o[l+m]*p;return r}let d=a*2,f=e-1;for(let p=0;p!==a;++p){let g=o[c+p],m=o[l+p],x=f*d+p*2,y=h[x],v=h[x+1],M=e*d+p*2,w=u[M],A=u[M+1],_=sM(n,t,y,w,s);r[p]=ig(_,g,v,A,m)}return r}};function ig(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function iM(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function sM(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=ig(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=iM(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Bn=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Er(t,this.TimeBufferType),this.values=Er(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Er(e.times,Array),values:Er(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Cl(e.settings)&&(n.settings={inTangents:Er(e.settings.inTangents,Array),outTangents:Er(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new ic(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new nc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new tc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new sc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Oo:t=this.InterpolantFactoryMethodDiscrete;break;case Wl:t=this.InterpolantFactoryMethodLinear;break;case Nl:t=this.InterpolantFactoryMethodSmooth;break;case Qh:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ie("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Oo;case this.InterpolantFactoryMethodLinear:return Wl;case this.InterpolantFactoryMethodSmooth:return Nl;case this.InterpolantFactoryMethodBezier:return Qh}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Cl(this.settings)&&(fm(this.settings.inTangents,e),fm(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Cl(this.settings)&&(pm(this.settings.inTangents,e),pm(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Ue("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Ue("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Ue("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Ue("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&_v(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Ue("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Nl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*n,d=h-n,f=h+n;for(let p=0;p!==n;++p){let g=t[h+p];if(g!==t[d+p]||g!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Cl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function fm(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function pm(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Bn.prototype.ValueTypeName="";Bn.prototype.TimeBufferType=Float32Array;Bn.prototype.ValueBufferType=Float32Array;Bn.prototype.DefaultInterpolation=Wl;var _s=class extends Bn{constructor(e,t,n){super(e,t,n)}};_s.prototype.ValueTypeName="bool";_s.prototype.ValueBufferType=Array;_s.prototype.DefaultInterpolation=Oo;_s.prototype.InterpolantFactoryMethodLinear=void 0;_s.prototype.InterpolantFactoryMethodSmooth=void 0;var rc=class extends Bn{constructor(e,t,n,s){super(e,t,n,s)}};rc.prototype.ValueTypeName="color";var oc=class extends Bn{constructor(e,t,n,s){super(e,t,n,s)}};oc.prototype.ValueTypeName="number";var ac=class extends ys{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)ot.slerpFlat(r,0,o,c-a,o,c,l);return r}},sa=class extends Bn{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new ac(this.times,this.values,this.getValueSize(),e)}};sa.prototype.ValueTypeName="quaternion";sa.prototype.InterpolantFactoryMethodSmooth=void 0;var vs=class extends Bn{constructor(e,t,n){super(e,t,n)}};vs.prototype.ValueTypeName="string";vs.prototype.ValueBufferType=Array;vs.prototype.DefaultInterpolation=Oo;vs.prototype.InterpolantFactoryMethodLinear=void 0;vs.prototype.InterpolantFactoryMethodSmooth=void 0;var lc=class extends Bn{constructor(e,t,n,s){super(e,t,n,s)}};lc.prototype.ValueTypeName="vector";var cc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},sg=new cc,uc=class{constructor(e){this.manager=e!==void 0?e:sg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};uc.DEFAULT_MATERIAL_NAME="__DEFAULT";var ra=class extends en{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Fe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Kh=new Qe,mm=new C,gm=new C,hc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ge(512,512),this.mapType=In,this.map=null,this.mapPass=null,this.matrix=new Qe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ms,this._frameExtents=new Ge(1,1),this._viewportCount=1,this._viewports=[new at(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;mm.setFromMatrixPosition(e.matrixWorld),t.position.copy(mm),gm.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(gm),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Kh.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Kh,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Dr||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Kh)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Il=new C,Pl=new ot,_i=new C,oa=class extends en{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qe,this.projectionMatrix=new Qe,this.projectionMatrixInverse=new Qe,this.coordinateSystem=jn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Il,Pl,_i),_i.x===1&&_i.y===1&&_i.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Il,Pl,_i.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Il,Pl,_i),_i.x===1&&_i.y===1&&_i.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Il,Pl,_i.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ps=new C,xm=new Ge,ym=new Ge,xn=class extends oa{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Fr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Pr*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Fr*2*Math.atan(Math.tan(Pr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){ps.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(ps.x,ps.y).multiplyScalar(-e/ps.z),ps.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(ps.x,ps.y).multiplyScalar(-e/ps.z)}getViewSize(e,t){return this.getViewBounds(e,xm,ym),t.subVectors(ym,xm)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Pr*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var aa=class extends oa{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},sd=class extends hc{constructor(){super(new aa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},la=class extends ra{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(en.DEFAULT_UP),this.updateMatrix(),this.target=new en,this.shadow=new sd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},ca=class extends ra{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var ua=class extends xt{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Tr=-90,Rr=1,Wr=class extends en{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new xn(Tr,Rr,e,t);s.layers=this.layers,this.add(s);let r=new xn(Tr,Rr,e,t);r.layers=this.layers,this.add(r);let o=new xn(Tr,Rr,e,t);o.layers=this.layers,this.add(o);let a=new xn(Tr,Rr,e,t);a.layers=this.layers,this.add(a);let l=new xn(Tr,Rr,e,t);l.layers=this.layers,this.add(l);let c=new xn(Tr,Rr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===jn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Dr)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let g=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=g,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},dc=class extends xn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Od="\\[\\]\\.:\\/",rM=new RegExp("["+Od+"]","g"),Bd="[^"+Od+"]",oM="[^"+Od.replace("\\.","")+"]",aM=/((?:WC+[\/:])*)/.source.replace("WC",Bd),lM=/(WCOD+)?/.source.replace("WCOD",oM),cM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Bd),uM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Bd),hM=new RegExp("^"+aM+lM+cM+uM+"$"),dM=["material","materials","bones","map"],rd=class{constructor(e,t,n){let s=n||vt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},vt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(rM,"")}static parseTrackName(e){let t=hM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);dM.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ie("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){Ue("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Ue("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Ue("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Ue("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Ue("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Ue("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){Ue("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Ue("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Ue("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Ue("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};vt.Composite=rd;vt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};vt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};vt.prototype.GetterByBindingType=[vt.prototype._getValue_direct,vt.prototype._getValue_array,vt.prototype._getValue_arrayElement,vt.prototype._getValue_toArray];vt.prototype.SetterByBindingTypeAndVersioning=[[vt.prototype._setValue_direct,vt.prototype._setValue_direct_setNeedsUpdate,vt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[vt.prototype._setValue_array,vt.prototype._setValue_array_setNeedsUpdate,vt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[vt.prototype._setValue_arrayElement,vt.prototype._setValue_arrayElement_setNeedsUpdate,vt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[vt.prototype._setValue_fromArray,vt.prototype._setValue_fromArray_setNeedsUpdate,vt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var HL=new Float32Array(1);var Ms=class extends $o{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var od=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var _m=new C,Ll=new C,Cr=new C,Ir=new C,Jh=new C,fM=new C,pM=new C,ha=class{constructor(e=new C,t=new C){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){_m.subVectors(e,this.start),Ll.subVectors(this.end,this.start);let n=Ll.dot(Ll);if(n===0)return 0;let r=Ll.dot(_m)/n;return t&&(r=Ve(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=fM,n=pM){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;Cr.subVectors(c,a),Ir.subVectors(u,l),Jh.subVectors(a,l);let h=Cr.dot(Cr),d=Ir.dot(Ir),f=Ir.dot(Jh);if(h<=s&&d<=s)return t.copy(a),n.copy(l),t.distanceToSquared(n);if(h<=s)r=0,o=f/d,o=Ve(o,0,1);else{let p=Cr.dot(Jh);if(d<=s)o=0,r=Ve(-p/h,0,1);else{let g=Cr.dot(Ir),m=h*d-g*g;m!==0?r=Ve((g*f-p*d)/m,0,1):r=0,o=(g*r+f)/d,o<0?(o=0,r=Ve(-p/h,0,1)):o>1&&(o=1,r=Ve((g-p)/h,0,1))}}return t.copy(a).addScaledVector(Cr,r),n.copy(l).addScaledVector(Ir,o),t.distanceToSquared(n)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};function kd(i,e,t,n){let s=mM(n);switch(t){case Ad:return i*e;case _c:return i*e/s.components*s.byteLength;case vc:return i*e/s.components*s.byteLength;case Ss:return i*e*2/s.components*s.byteLength;case Mc:return i*e*2/s.components*s.byteLength;case Ed:return i*e*3/s.components*s.byteLength;case di:return i*e*4/s.components*s.byteLength;case bc:return i*e*4/s.components*s.byteLength;case ma:case ga:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case xa:case ya:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case wc:case Ec:return Math.max(i,16)*Math.max(e,8)/4;case Sc:case Ac:return Math.max(i,8)*Math.max(e,8)/2;case Tc:case Rc:case Ic:case Pc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Cc:case _a:case Lc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Nc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Dc:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Uc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Fc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Oc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Bc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case kc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case zc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Gc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Vc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Hc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Wc:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case qc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Xc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case $c:case Yc:case Zc:return Math.ceil(i/4)*Math.ceil(e/4)*16;case jc:case Kc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case va:case Jc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function mM(i){switch(i){case In:case Md:return{byteLength:1,components:1};case Yr:case bd:case hi:return{byteLength:2,components:1};case xc:case yc:return{byteLength:2,components:4};case ui:case gc:case ei:return{byteLength:4,components:1};case Sd:case wd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ie("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Eg(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function vM(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],g=h[f];g.start<=p.start+p.count+1?p.count=Math.max(p.count,g.start+g.count-p.start):(++d,h[d]=g)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let g=h[f];i.bufferSubData(c,g.start*u.BYTES_PER_ELEMENT,u,g.start,g.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var MM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,bM=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,SM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,wM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,AM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,EM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,TM=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,RM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,CM=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,IM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,PM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,LM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,NM=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,DM=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,UM=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,FM=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,OM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,BM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,kM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,zM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,GM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,VM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,HM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,WM=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,qM=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,XM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,$M=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,YM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ZM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,jM="gl_FragColor = linearToOutputTexel( gl_FragColor );",KM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,JM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,QM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,eb=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,tb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,nb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,ib=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,sb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,rb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,ob=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,ab=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,lb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,cb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,ub=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,hb=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,db=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,fb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,pb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,mb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,gb=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,xb=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,yb=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,_b=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,vb=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Mb=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,bb=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Sb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,wb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ab=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Eb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Tb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Rb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Cb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Ib=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Pb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Lb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Nb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Db=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Ub=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Fb=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Ob=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Bb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,kb=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,zb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Gb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Vb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Hb=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Wb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,qb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Xb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,$b=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Yb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Zb=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,jb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Kb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Jb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Qb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,eS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,tS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,nS=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,iS=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,sS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,rS=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,oS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,aS=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,lS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,cS=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,uS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,hS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,dS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,fS=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,pS=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,mS=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,gS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,xS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,yS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,_S=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,vS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,MS=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,bS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,SS=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,wS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,AS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ES=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,TS=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,RS=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,CS=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,IS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,PS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,LS=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,NS=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,DS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,US=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,FS=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,OS=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,BS=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,kS=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,zS=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,GS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,VS=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,HS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,WS=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,qS=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,XS=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,$S=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,YS=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,ZS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,jS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,KS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,JS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,QS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Xe={alphahash_fragment:MM,alphahash_pars_fragment:bM,alphamap_fragment:SM,alphamap_pars_fragment:wM,alphatest_fragment:AM,alphatest_pars_fragment:EM,aomap_fragment:TM,aomap_pars_fragment:RM,batching_pars_vertex:CM,batching_vertex:IM,begin_vertex:PM,beginnormal_vertex:LM,bsdfs:NM,iridescence_fragment:DM,bumpmap_pars_fragment:UM,clipping_planes_fragment:FM,clipping_planes_pars_fragment:OM,clipping_planes_pars_vertex:BM,clipping_planes_vertex:kM,color_fragment:zM,color_pars_fragment:GM,color_pars_vertex:VM,color_vertex:HM,common:WM,defaultnormal_vertex:qM,displacementmap_pars_vertex:XM,displacementmap_vertex:$M,emissivemap_fragment:YM,emissivemap_pars_fragment:ZM,colorspace_fragment:jM,colorspace_pars_fragment:KM,envmap_fragment:JM,envmap_common_pars_fragment:QM,envmap_pars_fragment:eb,envmap_pars_vertex:tb,envmap_physical_pars_fragment:db,envmap_vertex:nb,fog_vertex:ib,fog_pars_vertex:sb,fog_fragment:rb,fog_pars_fragment:ob,gradientmap_pars_fragment:ab,lightmap_pars_fragment:lb,lights_lambert_fragment:cb,lights_lambert_pars_fragment:ub,lights_pars_begin:hb,lights_toon_fragment:fb,lights_toon_pars_fragment:pb,lights_phong_fragment:mb,lights_phong_pars_fragment:gb,lights_physical_fragment:xb,lights_physical_pars_fragment:yb,lights_fragment_begin:_b,lights_fragment_maps:vb,lights_fragment_end:Mb,lightprobes_pars_fragment:bb,logdepthbuf_fragment:Sb,logdepthbuf_pars_fragment:wb,logdepthbuf_pars_vertex:Ab,logdepthbuf_vertex:Eb,map_fragment:Tb,map_pars_fragment:Rb,map_particle_fragment:Cb,map_particle_pars_fragment:Ib,metalnessmap_fragment:Pb,metalnessmap_pars_fragment:Lb,morphinstance_vertex:Nb,morphcolor_vertex:Db,morphnormal_vertex:Ub,morphtarget_pars_vertex:Fb,morphtarget_vertex:Ob,normal_fragment_begin:Bb,normal_fragment_maps:kb,normal_pars_fragment:zb,normal_pars_vertex:Gb,normal_vertex:Vb,normalmap_pars_fragment:Hb,clearcoat_normal_fragment_begin:Wb,clearcoat_normal_fragment_maps:qb,clearcoat_pars_fragment:Xb,iridescence_pars_fragment:$b,opaque_fragment:Yb,packing:Zb,premultiplied_alpha_fragment:jb,project_vertex:Kb,dithering_fragment:Jb,dithering_pars_fragment:Qb,roughnessmap_fragment:eS,roughnessmap_pars_fragment:tS,shadowmap_pars_fragment:nS,shadowmap_pars_vertex:iS,shadowmap_vertex:sS,shadowmask_pars_fragment:rS,skinbase_vertex:oS,skinning_pars_vertex:aS,skinning_vertex:lS,skinnormal_vertex:cS,specularmap_fragment:uS,specularmap_pars_fragment:hS,tonemapping_fragment:dS,tonemapping_pars_fragment:fS,transmission_fragment:pS,transmission_pars_fragment:mS,uv_pars_fragment:gS,uv_pars_vertex:xS,uv_vertex:yS,worldpos_vertex:_S,background_vert:vS,background_frag:MS,backgroundCube_vert:bS,backgroundCube_frag:SS,cube_vert:wS,cube_frag:AS,depth_vert:ES,depth_frag:TS,distance_vert:RS,distance_frag:CS,equirect_vert:IS,equirect_frag:PS,linedashed_vert:LS,linedashed_frag:NS,meshbasic_vert:DS,meshbasic_frag:US,meshlambert_vert:FS,meshlambert_frag:OS,meshmatcap_vert:BS,meshmatcap_frag:kS,meshnormal_vert:zS,meshnormal_frag:GS,meshphong_vert:VS,meshphong_frag:HS,meshphysical_vert:WS,meshphysical_frag:qS,meshtoon_vert:XS,meshtoon_frag:$S,points_vert:YS,points_frag:ZS,shadow_vert:jS,shadow_frag:KS,sprite_vert:JS,sprite_frag:QS},fe={common:{diffuse:{value:new Fe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Oe},alphaMap:{value:null},alphaMapTransform:{value:new Oe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Oe}},envmap:{envMap:{value:null},envMapRotation:{value:new Oe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Oe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Oe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Oe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Oe},normalScale:{value:new Ge(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Oe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Oe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Oe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Oe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Fe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Fe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Oe},alphaTest:{value:0},uvTransform:{value:new Oe}},sprite:{diffuse:{value:new Fe(16777215)},opacity:{value:1},center:{value:new Ge(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Oe},alphaMap:{value:null},alphaMapTransform:{value:new Oe},alphaTest:{value:0}}},Mn={basic:{uniforms:fn([fe.common,fe.specularmap,fe.envmap,fe.aomap,fe.lightmap,fe.fog]),vertexShader:Xe.meshbasic_vert,fragmentShader:Xe.meshbasic_frag},lambert:{uniforms:fn([fe.common,fe.specularmap,fe.envmap,fe.aomap,fe.lightmap,fe.emissivemap,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.fog,fe.lights,{emissive:{value:new Fe(0)},envMapIntensity:{value:1}}]),vertexShader:Xe.meshlambert_vert,fragmentShader:Xe.meshlambert_frag},phong:{uniforms:fn([fe.common,fe.specularmap,fe.envmap,fe.aomap,fe.lightmap,fe.emissivemap,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.fog,fe.lights,{emissive:{value:new Fe(0)},specular:{value:new Fe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Xe.meshphong_vert,fragmentShader:Xe.meshphong_frag},standard:{uniforms:fn([fe.common,fe.envmap,fe.aomap,fe.lightmap,fe.emissivemap,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.roughnessmap,fe.metalnessmap,fe.fog,fe.lights,{emissive:{value:new Fe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Xe.meshphysical_vert,fragmentShader:Xe.meshphysical_frag},toon:{uniforms:fn([fe.common,fe.aomap,fe.lightmap,fe.emissivemap,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.gradientmap,fe.fog,fe.lights,{emissive:{value:new Fe(0)}}]),vertexShader:Xe.meshtoon_vert,fragmentShader:Xe.meshtoon_frag},matcap:{uniforms:fn([fe.common,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.fog,{matcap:{value:null}}]),vertexShader:Xe.meshmatcap_vert,fragmentShader:Xe.meshmatcap_frag},points:{uniforms:fn([fe.points,fe.fog]),vertexShader:Xe.points_vert,fragmentShader:Xe.points_frag},dashed:{uniforms:fn([fe.common,fe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Xe.linedashed_vert,fragmentShader:Xe.linedashed_frag},depth:{uniforms:fn([fe.common,fe.displacementmap]),vertexShader:Xe.depth_vert,fragmentShader:Xe.depth_frag},normal:{uniforms:fn([fe.common,fe.bumpmap,fe.normalmap,fe.displacementmap,{opacity:{value:1}}]),vertexShader:Xe.meshnormal_vert,fragmentShader:Xe.meshnormal_frag},sprite:{uniforms:fn([fe.sprite,fe.fog]),vertexShader:Xe.sprite_vert,fragmentShader:Xe.sprite_frag},background:{uniforms:{uvTransform:{value:new Oe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Xe.background_vert,fragmentShader:Xe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Oe}},vertexShader:Xe.backgroundCube_vert,fragmentShader:Xe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Xe.cube_vert,fragmentShader:Xe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Xe.equirect_vert,fragmentShader:Xe.equirect_frag},distance:{uniforms:fn([fe.common,fe.displacementmap,{referencePosition:{value:new C},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Xe.distance_vert,fragmentShader:Xe.distance_frag},shadow:{uniforms:fn([fe.lights,fe.fog,{color:{value:new Fe(0)},opacity:{value:1}}]),vertexShader:Xe.shadow_vert,fragmentShader:Xe.shadow_frag}};Mn.physical={uniforms:fn([Mn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Oe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Oe},clearcoatNormalScale:{value:new Ge(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Oe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Oe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Oe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Oe},sheen:{value:0},sheenColor:{value:new Fe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Oe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Oe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Oe},transmissionSamplerSize:{value:new Ge},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Oe},attenuationDistance:{value:0},attenuationColor:{value:new Fe(0)},specularColor:{value:new Fe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Oe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Oe},anisotropyVector:{value:new Ge},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Oe}}]),vertexShader:Xe.meshphysical_vert,fragmentShader:Xe.meshphysical_frag};var tu={r:0,b:0,g:0},e1=new Qe,Tg=new Oe;Tg.set(-1,0,0,0,1,0,0,0,1);function t1(i,e,t,n,s,r){let o=new Fe(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(y){let v=y.isScene===!0?y.background:null;if(v&&v.isTexture){let M=y.backgroundBlurriness>0;v=e.get(v,M)}return v}function p(y){let v=!1,M=f(y);M===null?m(o,a):M&&M.isColor&&(m(M,1),v=!0);let w=i.xr.getEnvironmentBlendMode();w==="additive"?t.buffers.color.setClear(0,0,0,1,r):w==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||v)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function g(y,v){let M=f(v);M&&M.isCubeTexture?(c===void 0&&(c=new $e(new $i(1,1,1),new Qn({name:"BackgroundCubeMaterial",uniforms:sr(Mn.backgroundCube.uniforms),vertexShader:Mn.backgroundCube.vertexShader,fragmentShader:Mn.backgroundCube.fragmentShader,side:vn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(w,A,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=v.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=v.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(e1.makeRotationFromEuler(v.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Tg),c.material.toneMapped=Ke.getTransfer(M.colorSpace)!==rt,(u!==M||h!==M.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,u=M,h=M.version,d=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new $e(new Qs(2,2),new Qn({name:"BackgroundMaterial",uniforms:sr(Mn.background.uniforms),vertexShader:Mn.background.vertexShader,fragmentShader:Mn.background.fragmentShader,side:bs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=v.backgroundIntensity,l.material.toneMapped=Ke.getTransfer(M.colorSpace)!==rt,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(u!==M||h!==M.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,u=M,h=M.version,d=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,v){y.getRGB(tu,Fd(i)),t.buffers.color.setClear(tu.r,tu.g,tu.b,v,r)}function x(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,v=1){o.set(y),a=v,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,m(o,a)},render:p,addToRenderList:g,dispose:x}}function n1(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(L,D,O,P,B){let H=!1,V=h(L,P,O,D);r!==V&&(r=V,c(r.object)),H=f(L,P,O,B),H&&p(L,P,O,B),B!==null&&e.update(B,i.ELEMENT_ARRAY_BUFFER),(H||o)&&(o=!1,M(L,D,O,P),B!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(B).buffer))}function l(){return i.createVertexArray()}function c(L){return i.bindVertexArray(L)}function u(L){return i.deleteVertexArray(L)}function h(L,D,O,P){let B=P.wireframe===!0,H=n[D.id];H===void 0&&(H={},n[D.id]=H);let V=L.isInstancedMesh===!0?L.id:0,ee=H[V];ee===void 0&&(ee={},H[V]=ee);let X=ee[O.id];X===void 0&&(X={},ee[O.id]=X);let j=X[B];return j===void 0&&(j=d(l()),X[B]=j),j}function d(L){let D=[],O=[],P=[];for(let B=0;B<t;B++)D[B]=0,O[B]=0,P[B]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:D,enabledAttributes:O,attributeDivisors:P,object:L,attributes:{},index:null}}function f(L,D,O,P){let B=r.attributes,H=D.attributes,V=0,ee=O.getAttributes();for(let X in ee)if(ee[X].location>=0){let te=B[X],ve=H[X];if(ve===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(ve=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(ve=L.instanceColor)),te===void 0||te.attribute!==ve||ve&&te.data!==ve.data)return!0;V++}return r.attributesNum!==V||r.index!==P}function p(L,D,O,P){let B={},H=D.attributes,V=0,ee=O.getAttributes();for(let X in ee)if(ee[X].location>=0){let te=H[X];te===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(te=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(te=L.instanceColor));let ve={};ve.attribute=te,te&&te.data&&(ve.data=te.data),B[X]=ve,V++}r.attributes=B,r.attributesNum=V,r.index=P}function g(){let L=r.newAttributes;for(let D=0,O=L.length;D<O;D++)L[D]=0}function m(L){x(L,0)}function x(L,D){let O=r.newAttributes,P=r.enabledAttributes,B=r.attributeDivisors;O[L]=1,P[L]===0&&(i.enableVertexAttribArray(L),P[L]=1),B[L]!==D&&(i.vertexAttribDivisor(L,D),B[L]=D)}function y(){let L=r.newAttributes,D=r.enabledAttributes;for(let O=0,P=D.length;O<P;O++)D[O]!==L[O]&&(i.disableVertexAttribArray(O),D[O]=0)}function v(L,D,O,P,B,H,V){V===!0?i.vertexAttribIPointer(L,D,O,B,H):i.vertexAttribPointer(L,D,O,P,B,H)}function M(L,D,O,P){g();let B=P.attributes,H=O.getAttributes(),V=D.defaultAttributeValues;for(let ee in H){let X=H[ee];if(X.location>=0){let j=B[ee];if(j===void 0&&(ee==="instanceMatrix"&&L.instanceMatrix&&(j=L.instanceMatrix),ee==="instanceColor"&&L.instanceColor&&(j=L.instanceColor)),j!==void 0){let te=j.normalized,ve=j.itemSize,Pe=e.get(j);if(Pe===void 0)continue;let Y=Pe.buffer,ge=Pe.type,Me=Pe.bytesPerElement,Le=ge===i.INT||ge===i.UNSIGNED_INT||j.gpuType===gc;if(j.isInterleavedBufferAttribute){let ye=j.data,ze=ye.isInterleavedBuffer===!0?ye.stride:ye.itemSize,Pt=j.offset;if(ye.isInstancedInterleavedBuffer||ye.isInstancedBufferAttribute){for(let De=0;De<X.locationSize;De++)x(X.location+De,ye.meshPerAttribute);L.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=ye.meshPerAttribute*ye.count)}else for(let De=0;De<X.locationSize;De++)m(X.location+De);i.bindBuffer(i.ARRAY_BUFFER,Y);for(let De=0;De<X.locationSize;De++)v(X.location+De,ve/X.locationSize,ge,te,ze*Me,(Pt+ve/X.locationSize*De)*Me,Le)}else{if(j.isInstancedBufferAttribute){for(let ye=0;ye<X.locationSize;ye++)x(X.location+ye,j.meshPerAttribute);L.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let ye=0;ye<X.locationSize;ye++)m(X.location+ye);i.bindBuffer(i.ARRAY_BUFFER,Y);for(let ye=0;ye<X.locationSize;ye++)v(X.location+ye,ve/X.locationSize,ge,te,ve*Me,ve/X.locationSize*ye*Me,Le)}}else if(V!==void 0){let te=V[ee];if(te!==void 0)switch(te.length){case 2:i.vertexAttrib2fv(X.location,te);break;case 3:i.vertexAttrib3fv(X.location,te);break;case 4:i.vertexAttrib4fv(X.location,te);break;default:i.vertexAttrib1fv(X.location,te)}}}}y()}function w(){I();for(let L in n){let D=n[L];for(let O in D){let P=D[O];for(let B in P){let H=P[B];for(let V in H)u(H[V].object),delete H[V];delete P[B]}}delete n[L]}}function A(L){if(n[L.id]===void 0)return;let D=n[L.id];for(let O in D){let P=D[O];for(let B in P){let H=P[B];for(let V in H)u(H[V].object),delete H[V];delete P[B]}}delete n[L.id]}function _(L){for(let D in n){let O=n[D];for(let P in O){let B=O[P];if(B[L.id]===void 0)continue;let H=B[L.id];for(let V in H)u(H[V].object),delete H[V];delete B[L.id]}}}function b(L){for(let D in n){let O=n[D],P=L.isInstancedMesh===!0?L.id:0,B=O[P];if(B!==void 0){for(let H in B){let V=B[H];for(let ee in V)u(V[ee].object),delete V[ee];delete B[H]}delete O[P],Object.keys(O).length===0&&delete n[D]}}}function I(){T(),o=!0,r!==s&&(r=s,c(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:T,dispose:w,releaseStatesOfGeometry:A,releaseStatesOfObject:b,releaseStatesOfProgram:_,initAttributes:g,enableAttribute:m,disableUnusedAttributes:y}}function i1(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,u){u!==0&&(i.drawArraysInstanced(n,l,c,u),t.update(c,n,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function s1(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==di&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let b=_===hi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==In&&_!==ei&&!b&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ie("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Ie("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Ie("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),x=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),v=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),w=i.getParameter(i.MAX_SAMPLES),A=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:g,maxCubemapSize:m,maxAttributes:x,maxVertexUniforms:y,maxVaryings:v,maxFragmentUniforms:M,maxSamples:w,samples:A}}function r1(i){let e=this,t=null,n=0,s=!1,r=!1,o=new ai,a=new Oe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||n!==0||s;return s=d,n=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,g=h.clipIntersection,m=h.clipShadows,x=i.get(h);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let y=r?0:n,v=y*4,M=x.clippingState||null;l.value=M,M=u(p,d,v,f);for(let w=0;w!==v;++w)M[w]=t[w];x.clippingState=M,this.numIntersection=g?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,d,f,p){let g=h!==null?h.length:0,m=null;if(g!==0){if(m=l.value,p!==!0||m===null){let x=f+g*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<x)&&(m=new Float32Array(x));for(let v=0,M=f;v!==g;++v,M+=4)o.copy(h[v]).applyMatrix4(y,a),o.normal.toArray(m,M),m[M+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=g,e.numIntersection=0,m}}var wa=class extends Fn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new jo(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new $i(5,5,5),r=new Qn({name:"CubemapFromEquirect",uniforms:sr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:vn,blending:er});r.uniforms.tEquirect.value=t;let o=new $e(s,r),a=t.minFilter;return t.minFilter===Yi&&(t.minFilter=Ft),new Wr(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},rg=256,o1=3,a1=20,Rg=256,Cg=16,l1=3,c1=new C,u1=new Fe,iu=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Wr(1,10,null),this._boxMesh=new $e(new $i(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=c1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,g=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,g===null&&(e.background=l.getClearColor(u1));let m=new Wr(n,s,u);return m.position.copy(a),m.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,e.background=g,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=lg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ag(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(rg,Nd(e))}_fromTexture(e,t){e.mapping===nr||e.mapping===$r?this._setSize(e.image.length===0?rg:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=og(e,!1,!1),n=Math.log2(e)-o1;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=og(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===nr||e.mapping===$r?(this._cubemapMaterial===null&&(this._cubemapMaterial=lg()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=ag()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=h1(),this._integrationMaterial=d1());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Cg);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-l1)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Rg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=f1());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function og(i,e,t){return new wa(i,{minFilter:Yi,generateMipmaps:e,type:hi,colorSpace:Bo,depthBuffer:t})}function Aa(i,e,t){return new Qn({name:i,uniforms:e,vertexShader:Xe.cube_vert,fragmentShader:t,side:vn,blending:er,depthTest:!1,depthWrite:!1})}function h1(){return Aa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Rg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function d1(){return Aa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Cg}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function f1(){return Aa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${a1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function ag(){return Aa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function lg(){return Aa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function p1(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===fc||f===pc)if(e.has(d)){let p=e.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let g=new wa(p.height);return g.fromEquirectangularTexture(i,d),e.set(d,g),d.addEventListener("dispose",c),a(g.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===fc||f===pc,g=f===nr||f===$r;if(p||g){let m=t.get(d),x=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==x)return n===null&&(n=new iu(i)),m=p?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let y=d.image;return p&&y&&y.height>0||g&&y&&l(y)?(n===null&&(n=new iu(i)),m=p?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===fc?d.mapping=nr:f===pc&&(d.mapping=$r),d}function l(d){let f=0,p=6;for(let g=0;g<p;g++)d[g]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:h}}function m1(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Uo("WebGLRenderer: "+n+" extension not supported."),s}}}function g1(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let g=r.get(p);g&&(e.remove(g),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,g){return s[g.id]!==void 0||(g.addEventListener("dispose",a),s[g.id]=new WeakRef(g),o.register(g,g.id,g),t.memory.geometries++),g}function u(p){let g=p.attributes;for(let m in g)e.update(g[m],i.ARRAY_BUFFER)}function h(p){let g=p.index,m=p.attributes.position,x=0;if(m===void 0)return;let y=g!==null?g.array.length:m.array.length/3-1,v=m.count>=65535?Xo:qo,M=new v(Math.ceil(y/3)*6,1),w=M.array;if(g!==null){let _=g.array;x=g.version;for(let b=0,I=0;b<y;b+=3){let T=_[b+0],L=_[b+1],D=_[b+2];w[I++]=T,w[I++]=L,w[I++]=L,w[I++]=D,w[I++]=D,w[I++]=T}}else{x=m.version;for(let _=0,b=0;_<y;_+=3){let I=_+0,T=_+1,L=_+2;w[b++]=I,w[b++]=T,w[b++]=T,w[b++]=L,w[b++]=L,w[b++]=I}}M.version=x;let A=r.get(p);A&&e.remove(A),r.set(p,M)}function d(p){let g=r.get(p);if(g){let m=p.index;m!==null&&g.version<m.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let g=s[p].deref();g!==void 0&&l(g)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function x1(i,e,t){let n;function s(h){n=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){i.drawElements(n,d,r,h*o),t.update(d,n,1)}function c(h,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,h*o,f),t.update(d,n,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,h,0,f);let g=0;for(let m=0;m<f;m++)g+=d[m];t.update(g,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function y1(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:Ue("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function _1(i,e,t){let n=new WeakMap,s=new at;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=n.get(a);if(d===void 0||d.count!==h){let I=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",I)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,g=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],x=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],v=0;f===!0&&(v=1),p===!0&&(v=2),g===!0&&(v=3);let M=a.attributes.position.count*v,w=1;M>e.maxTextureSize&&(w=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);let A=new Float32Array(M*w*4*h),_=new Vo(A,M,w,h);_.type=ei,_.needsUpdate=!0;let b=v*4;for(let T=0;T<h;T++){let L=m[T],D=x[T],O=y[T],P=M*w*4*T;for(let B=0;B<L.count;B++){let H=B*b;f===!0&&(s.fromBufferAttribute(L,B),A[P+H+0]=s.x,A[P+H+1]=s.y,A[P+H+2]=s.z,A[P+H+3]=0),p===!0&&(s.fromBufferAttribute(D,B),A[P+H+4]=s.x,A[P+H+5]=s.y,A[P+H+6]=s.z,A[P+H+7]=0),g===!0&&(s.fromBufferAttribute(O,B),A[P+H+8]=s.x,A[P+H+9]=s.y,A[P+H+10]=s.z,A[P+H+11]=O.itemSize===4?s.w:1)}}d={count:h,texture:_,size:new Ge(M,w)},n.set(a,d),a.addEventListener("dispose",I)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let g=0;g<c.length;g++)f+=c[g];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function v1(i,e,t,n,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var M1={[fd]:"LINEAR_TONE_MAPPING",[pd]:"REINHARD_TONE_MAPPING",[md]:"CINEON_TONE_MAPPING",[gd]:"ACES_FILMIC_TONE_MAPPING",[yd]:"AGX_TONE_MAPPING",[_d]:"NEUTRAL_TONE_MAPPING",[xd]:"CUSTOM_TONE_MAPPING"};function b1(i,e,t,n,s,r){let o=new Fn(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new xt;u.setAttribute("position",new tt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new tt([0,2,0,0,2,0],2));let h=new Jl({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new $e(u,h),f=new aa(-1,1,1,-1,0,1),p=null,g=null,m=!1,x,y=null,v=[],M=!1;this.setSize=function(w,A){o.setSize(w,A),a!==null&&a.setSize(w,A),l!==null&&l.setSize(w,A);for(let _=0;_<v.length;_++){let b=v[_];b.setSize&&b.setSize(w,A)}},this.setEffects=function(w){v=w,M=v.length>0&&v[0].isRenderPass===!0;let A=o.width,_=o.height;v.length>0&&a===null&&(a=new Fn(A,_,{type:hi,depthBuffer:!1,stencilBuffer:!1}),l=new Fn(A,_,{type:hi,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&v.some(I=>I.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&c===null&&(c=new Xi(A,_),r===!0&&(c.format=Zi,c.type=ir)),o.dispose(),o.depthTexture=b?c:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let I=0;I<v.length;I++){let T=v[I];T.setSize&&T.setSize(A,_),b&&T.needsDepthTexture===!0&&T.setDepthTexture&&T.setDepthTexture(c)}},this.begin=function(w,A){if(m||w.toneMapping===wi&&v.length===0)return!1;if(y=A,A!==null){let _=A.width,b=A.height;(o.width!==_||o.height!==b)&&this.setSize(_,b)}return M===!1&&w.setRenderTarget(o),x=w.toneMapping,w.toneMapping=wi,!0},this.hasRenderPass=function(){return M},this.end=function(w,A){w.toneMapping=x,m=!0;let _=o,b=a;for(let I=0;I<v.length;I++){let T=v[I];T.enabled!==!1&&(T.render(w,b,_,A),T.needsSwap!==!1&&(_=b,b=b===a?l:a))}if(p!==w.outputColorSpace||g!==w.toneMapping){p=w.outputColorSpace,g=w.toneMapping,h.defines={},Ke.getTransfer(p)===rt&&(h.defines.SRGB_TRANSFER="");let I=M1[g];I&&(h.defines[I]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=_.texture,w.setRenderTarget(y),w.render(d,f),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Ig=new Rn,Pg=new Xi(1,1),Lg=new Ko(1),Ng=new Vo,Dg=new $l,Ug=new jo,cg=[],ug=[],hg=new Float32Array(16),dg=new Float32Array(9),fg=new Float32Array(4);function Kr(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=cg[s];if(r===void 0&&(r=new Float32Array(s),cg[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Ot(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Bt(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function ru(i,e){let t=ug[e];t===void 0&&(t=new Int32Array(e),ug[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function S1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function w1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ot(t,e))return;i.uniform2fv(this.addr,e),Bt(t,e)}}function A1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Ot(t,e))return;i.uniform3fv(this.addr,e),Bt(t,e)}}function E1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ot(t,e))return;i.uniform4fv(this.addr,e),Bt(t,e)}}function T1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Ot(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Bt(t,e)}else{if(Ot(t,n))return;fg.set(n),i.uniformMatrix2fv(this.addr,!1,fg),Bt(t,n)}}function R1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Ot(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Bt(t,e)}else{if(Ot(t,n))return;dg.set(n),i.uniformMatrix3fv(this.addr,!1,dg),Bt(t,n)}}function C1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Ot(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Bt(t,e)}else{if(Ot(t,n))return;hg.set(n),i.uniformMatrix4fv(this.addr,!1,hg),Bt(t,n)}}function I1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function P1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ot(t,e))return;i.uniform2iv(this.addr,e),Bt(t,e)}}function L1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ot(t,e))return;i.uniform3iv(this.addr,e),Bt(t,e)}}function N1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ot(t,e))return;i.uniform4iv(this.addr,e),Bt(t,e)}}function D1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function U1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ot(t,e))return;i.uniform2uiv(this.addr,e),Bt(t,e)}}function F1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ot(t,e))return;i.uniform3uiv(this.addr,e),Bt(t,e)}}function O1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ot(t,e))return;i.uniform4uiv(this.addr,e),Bt(t,e)}}function ou(i){return i.version===0&&(i.compareFunction=Cd,i.needsUpdate=!0),i}function B1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=ou(Pg):r=Ig,t.setTexture2D(e||r,s)}function k1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Dg,s)}function z1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=ou(Lg):r=Ug,t.setTextureCube(e||r,s)}function G1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Ng,s)}function V1(i){switch(i){case 5126:return S1;case 35664:return w1;case 35665:return A1;case 35666:return E1;case 35674:return T1;case 35675:return R1;case 35676:return C1;case 5124:case 35670:return I1;case 35667:case 35671:return P1;case 35668:case 35672:return L1;case 35669:case 35673:return N1;case 5125:return D1;case 36294:return U1;case 36295:return F1;case 36296:return O1;case 35678:case 36198:case 36298:case 36306:case 35682:return B1;case 35679:case 36299:case 36307:return k1;case 35680:case 36300:case 36308:case 36293:return z1;case 36289:case 36303:case 36311:case 36292:return G1}}function H1(i,e){i.uniform1fv(this.addr,e)}function W1(i,e){let t=Kr(e,this.size,2);i.uniform2fv(this.addr,t)}function q1(i,e){let t=Kr(e,this.size,3);i.uniform3fv(this.addr,t)}function X1(i,e){let t=Kr(e,this.size,4);i.uniform4fv(this.addr,t)}function $1(i,e){let t=Kr(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function Y1(i,e){let t=Kr(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function Z1(i,e){let t=Kr(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function j1(i,e){i.uniform1iv(this.addr,e)}function K1(i,e){i.uniform2iv(this.addr,e)}function J1(i,e){i.uniform3iv(this.addr,e)}function Q1(i,e){i.uniform4iv(this.addr,e)}function ew(i,e){i.uniform1uiv(this.addr,e)}function tw(i,e){i.uniform2uiv(this.addr,e)}function nw(i,e){i.uniform3uiv(this.addr,e)}function iw(i,e){i.uniform4uiv(this.addr,e)}function sw(i,e,t){let n=this.cache,s=e.length,r=ru(t,s);Ot(n,r)||(i.uniform1iv(this.addr,r),Bt(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=ou(Pg):o=Ig;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function rw(i,e,t){let n=this.cache,s=e.length,r=ru(t,s);Ot(n,r)||(i.uniform1iv(this.addr,r),Bt(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Dg,r[o])}function ow(i,e,t){let n=this.cache,s=e.length,r=ru(t,s);Ot(n,r)||(i.uniform1iv(this.addr,r),Bt(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=ou(Lg):o=Ug;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function aw(i,e,t){let n=this.cache,s=e.length,r=ru(t,s);Ot(n,r)||(i.uniform1iv(this.addr,r),Bt(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Ng,r[o])}function lw(i){switch(i){case 5126:return H1;case 35664:return W1;case 35665:return q1;case 35666:return X1;case 35674:return $1;case 35675:return Y1;case 35676:return Z1;case 5124:case 35670:return j1;case 35667:case 35671:return K1;case 35668:case 35672:return J1;case 35669:case 35673:return Q1;case 5125:return ew;case 36294:return tw;case 36295:return nw;case 36296:return iw;case 35678:case 36198:case 36298:case 36306:case 35682:return sw;case 35679:case 36299:case 36307:return rw;case 35680:case 36300:case 36308:case 36293:return ow;case 36289:case 36303:case 36311:case 36292:return aw}}var Vd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=V1(t.type)}},Hd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=lw(t.type)}},Wd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},zd=/(\w+)(\])?(\[|\.)?/g;function pg(i,e){i.seq.push(e),i.map[e.id]=e}function cw(i,e,t){let n=i.name,s=n.length;for(zd.lastIndex=0;;){let r=zd.exec(n),o=zd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){pg(t,c===void 0?new Vd(a,i,e):new Hd(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new Wd(a),pg(t,h)),t=h}}}var jr=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);cw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function mg(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var uw=37297,hw=0;function dw(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var gg=new Oe;function fw(i){Ke._getMatrix(gg,Ke.workingColorSpace,i);let e=`mat3( ${gg.elements.map(t=>t.toFixed(4))} )`;switch(Ke.getTransfer(i)){case ko:return[e,"LinearTransferOETF"];case rt:return[e,"sRGBTransferOETF"];default:return Ie("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function xg(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+dw(i.getShaderSource(e),a)}else return r}function pw(i,e){let t=fw(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var mw={[fd]:"Linear",[pd]:"Reinhard",[md]:"Cineon",[gd]:"ACESFilmic",[yd]:"AgX",[_d]:"Neutral",[xd]:"Custom"};function gw(i,e){let t=mw[e];return t===void 0?(Ie("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var nu=new C;function xw(){Ke.getLuminanceCoefficients(nu);let i=nu.x.toFixed(4),e=nu.y.toFixed(4),t=nu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function yw(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Sa).join(`
`)}function _w(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function vw(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Sa(i){return i!==""}function yg(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function _g(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var Mw=/^[ \t]*#include +<([\w\d./]+)>/gm;function qd(i){return i.replace(Mw,bw)}function bw(i,e){let t=Xe[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return qd(t)}var Sw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function vg(i){return i.replace(Sw,ww)}function ww(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Mg(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var Aw={[da]:"SHADOWMAP_TYPE_PCF",[qr]:"SHADOWMAP_TYPE_VSM"};function Ew(i){return Aw[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Tw={[$r]:"ENVMAP_MODE_REFRACTION"};function Rw(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Tw[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Cw={[fa]:"ENVMAP_BLENDING_MULTIPLY",[Gm]:"ENVMAP_BLENDING_MIX",[Vm]:"ENVMAP_BLENDING_ADD"};function Iw(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Cw[i.combine]||"ENVMAP_BLENDING_NONE"}function Pw(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=Ew(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=Rw(t),h=Iw(t),d=yw(t),f=_w(r),p=s.createProgram(),g,m,x=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Sa).join(`
`),g.length>0&&(g+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Sa).join(`
`),m.length>0&&(m+=`
`)):(g=[Mg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Sa).join(`
`),m=[Mg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==wi?"#define TONE_MAPPING":"",t.toneMapping!==wi?Xe.tonemapping_pars_fragment:"",t.toneMapping!==wi?gw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",Xe.colorspace_pars_fragment,pw("linearToOutputTexel",t.outputColorSpace),xw(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Sa).join(`
`)),o=qd(o),o=yg(o,t),o=_g(o,t),a=qd(a),a=yg(a,t),a=_g(a,t),o=vg(o),a=vg(a),t.isRawShaderMaterial!==!0&&(x=`#version 300 es
`,g=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+g,m=["#define varying in",t.glslVersion===Pd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Pd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=x+g+o,v=x+m+a,M=mg(s,s.VERTEX_SHADER,y),w=mg(s,s.FRAGMENT_SHADER,v);s.attachShader(p,M),s.attachShader(p,w),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function A(T){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",D=s.getShaderInfoLog(M)||"",O=s.getShaderInfoLog(w)||"",P=L.trim(),B=D.trim(),H=O.trim(),V=!0,ee=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(V=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,M,w);else{let X=xg(s,M,"vertex"),j=xg(s,w,"fragment");Ue("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+T.name+`
Material Type: `+T.type+`

Program Info Log: `+P+`
`+X+`
`+j)}else P!==""?Ie("WebGLProgram: Program Info Log:",P):(B===""||H==="")&&(ee=!1);ee&&(T.diagnostics={runnable:V,programLog:P,vertexShader:{log:B,prefix:g},fragmentShader:{log:H,prefix:m}})}s.deleteShader(M),s.deleteShader(w),_=new jr(s,p),b=vw(s,p)}let _;this.getUniforms=function(){return _===void 0&&A(this),_};let b;this.getAttributes=function(){return b===void 0&&A(this),b};let I=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=s.getProgramParameter(p,uw)),I},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=hw++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=M,this.fragmentShader=w,this}var Lw=0,Xd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new $d(e),t.set(e,n)),n}},$d=class{constructor(e){this.id=Lw++,this.code=e,this.usedTimes=0}};function Nw(i){return i===Ss||i===_a||i===va}function Dw(i,e,t,n,s,r){let o=new Ho,a=new Xd,l=new Set,c=[],u=new Map,h=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function p(_,b,I,T,L,D){let O=T.fog,P=L.geometry,B=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?T.environment:null,H=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,V=e.get(_.envMap||B,H),ee=d[_.type],X=n.precision;_.precision!==null&&(X=n.getMaxPrecision(_.precision),X!==_.precision&&Ie("WebGLProgram.getParameters:",_.precision,"not supported, using",X,"instead."));let j=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,te=j!==void 0?j.length:0,ve=0;P.morphAttributes.position!==void 0&&(ve=1),P.morphAttributes.normal!==void 0&&(ve=2),P.morphAttributes.color!==void 0&&(ve=3);let Pe,Y,ge,Me;if(ee){let xe=Mn[ee];Pe=xe.vertexShader,Y=xe.fragmentShader}else{Pe=_.vertexShader,Y=_.fragmentShader;let xe=a.getVertexShaderStage(_),ct=a.getFragmentShaderStage(_);a.update(_,xe,ct),ge=xe.id,Me=ct.id}let Le=i.getRenderTarget(),ye=i.state.buffers.depth.getReversed(),ze=L.isInstancedMesh===!0,Pt=L.isBatchedMesh===!0,De=!!_.map,lt=!!_.matcap,ft=!!V,Ye=ft&&V.isPMREMTexture===!0,Jt=!!_.aoMap,Dt=!!_.lightMap,En=!!_.bumpMap&&_.wireframe===!1,Tt=!!_.normalMap,yi=!!_.displacementMap,Gt=!!_.emissiveMap,qn=!!_.metalnessMap,Xn=!!_.roughnessMap,$n=_.anisotropy>0,F=_.clearcoat>0,Yn=_.diffuseRoughness>0,St=_.dispersion>0,wt=_.retroreflectivity>0,pe=_.iridescence>0,Ut=_.sheen>0,Ne=_.transmission>0,Be=$n&&!!_.anisotropyMap,R=F&&!!_.clearcoatMap,S=F&&!!_.clearcoatNormalMap,z=F&&!!_.clearcoatRoughnessMap,ne=Yn&&!!_.diffuseRoughnessMap,Q=pe&&!!_.iridescenceMap,re=pe&&!!_.iridescenceThicknessMap,ue=Ut&&!!_.sheenColorMap,Z=Ut&&!!_.sheenRoughnessMap,K=!!_.specularMap,ae=!!_.specularColorMap,N=!!_.specularIntensityMap,J=Ne&&!!_.transmissionMap,$=Ne&&!!_.thicknessMap,le=!!_.gradientMap,se=!!_.alphaMap,oe=_.alphaTest>0,Re=!!_.alphaHash,qe=!!_.extensions,ie=wi;_.toneMapped&&(Le===null||Le.isXRRenderTarget===!0)&&(ie=i.toneMapping);let Ce=Ye?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,We={shaderID:ee,shaderType:_.type,shaderName:_.name,vertexShader:Pe,fragmentShader:Y,defines:_.defines,customVertexShaderID:ge,customFragmentShaderID:Me,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:X,batching:Pt,batchingColor:Pt&&L._colorsTexture!==null,instancing:ze,instancingColor:ze&&L.instanceColor!==null,instancingMorph:ze&&L.morphTexture!==null,outputColorSpace:Le===null?i.outputColorSpace:Le.isXRRenderTarget===!0?Le.texture.colorSpace:Ke.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:De,matcap:lt,envMap:ft,envMapMode:ft&&V.mapping,envMapPMREM:Ye,envMapMaxLod:Ye?Ce.length-1:null,envMapSize:Ye?Ce[0].width:null,aoMap:Jt,lightMap:Dt,bumpMap:En,normalMap:Tt,displacementMap:yi,emissiveMap:Gt,normalMapObjectSpace:Tt&&_.normalMapType===qm,normalMapTangentSpace:Tt&&_.normalMapType===Zr,packedNormalMap:Tt&&_.normalMapType===Zr&&Nw(_.normalMap.format),metalnessMap:qn,roughnessMap:Xn,anisotropy:$n,anisotropyMap:Be,clearcoat:F,clearcoatMap:R,clearcoatNormalMap:S,clearcoatRoughnessMap:z,diffuseRoughness:Yn,diffuseRoughnessMap:ne,dispersion:St,retroreflection:wt,iridescence:pe,iridescenceMap:Q,iridescenceThicknessMap:re,sheen:Ut,sheenColorMap:ue,sheenRoughnessMap:Z,specularMap:K,specularColorMap:ae,specularIntensityMap:N,transmission:Ne,transmissionMap:J,thicknessMap:$,gradientMap:le,opaque:_.transparent===!1&&_.blending===Xr&&_.alphaToCoverage===!1,alphaMap:se,alphaTest:oe,alphaHash:Re,combine:_.combine,mapUv:De&&f(_.map.channel),aoMapUv:Jt&&f(_.aoMap.channel),lightMapUv:Dt&&f(_.lightMap.channel),bumpMapUv:En&&f(_.bumpMap.channel),normalMapUv:Tt&&f(_.normalMap.channel),displacementMapUv:yi&&f(_.displacementMap.channel),emissiveMapUv:Gt&&f(_.emissiveMap.channel),metalnessMapUv:qn&&f(_.metalnessMap.channel),roughnessMapUv:Xn&&f(_.roughnessMap.channel),anisotropyMapUv:Be&&f(_.anisotropyMap.channel),clearcoatMapUv:R&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:z&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ne&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:re&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:ue&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:Z&&f(_.sheenRoughnessMap.channel),specularMapUv:K&&f(_.specularMap.channel),specularColorMapUv:ae&&f(_.specularColorMap.channel),specularIntensityMapUv:N&&f(_.specularIntensityMap.channel),transmissionMapUv:J&&f(_.transmissionMap.channel),thicknessMapUv:$&&f(_.thicknessMap.channel),alphaMapUv:se&&f(_.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(Tt||$n),vertexNormals:!!P.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!P.attributes.uv&&(De||se),fog:!!O,useFog:_.fog===!0,fogExp2:!!O&&O.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||P.attributes.normal===void 0&&Tt===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:ye,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:ve,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:D.filter(xe=>xe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&I.length>0,shadowMapType:i.shadowMap.type,toneMapping:ie,decodeVideoTexture:De&&_.map.isVideoTexture===!0&&Ke.getTransfer(_.map.colorSpace)===rt,decodeVideoTextureEmissive:Gt&&_.emissiveMap.isVideoTexture===!0&&Ke.getTransfer(_.emissiveMap.colorSpace)===rt,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Si,flipSided:_.side===vn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:qe&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(qe&&_.extensions.multiDraw===!0||Pt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return We.vertexUv1s=l.has(1),We.vertexUv2s=l.has(2),We.vertexUv3s=l.has(3),l.clear(),We}function g(_){let b=[];if(_.shaderID?b.push(_.shaderID):(b.push(_.customVertexShaderID),b.push(_.customFragmentShaderID)),_.defines!==void 0)for(let I in _.defines)b.push(I),b.push(_.defines[I]);return _.isRawShaderMaterial===!1&&(m(b,_),x(b,_),b.push(i.outputColorSpace)),b.push(_.customProgramCacheKey),b.join()}function m(_,b){_.push(b.precision),_.push(b.outputColorSpace),_.push(b.envMapMode),_.push(b.envMapPMREM),_.push(b.envMapMaxLod),_.push(b.envMapSize),_.push(b.mapUv),_.push(b.alphaMapUv),_.push(b.lightMapUv),_.push(b.aoMapUv),_.push(b.bumpMapUv),_.push(b.normalMapUv),_.push(b.displacementMapUv),_.push(b.emissiveMapUv),_.push(b.metalnessMapUv),_.push(b.roughnessMapUv),_.push(b.anisotropyMapUv),_.push(b.clearcoatMapUv),_.push(b.clearcoatNormalMapUv),_.push(b.clearcoatRoughnessMapUv),_.push(b.diffuseRoughnessMapUv),_.push(b.iridescenceMapUv),_.push(b.iridescenceThicknessMapUv),_.push(b.sheenColorMapUv),_.push(b.sheenRoughnessMapUv),_.push(b.specularMapUv),_.push(b.specularColorMapUv),_.push(b.specularIntensityMapUv),_.push(b.transmissionMapUv),_.push(b.thicknessMapUv),_.push(b.combine),_.push(b.fogExp2),_.push(b.sizeAttenuation),_.push(b.morphTargetsCount),_.push(b.numSunLights),_.push(b.numDirLights),_.push(b.numPointLights),_.push(b.numSpotLights),_.push(b.numSpotLightMaps),_.push(b.numHemiLights),_.push(b.numRectAreaLights),_.push(b.numSunLightShadows),_.push(b.numDirLightShadows),_.push(b.numPointLightShadows),_.push(b.numSpotLightShadows),_.push(b.numSpotLightShadowsWithMaps),_.push(b.numLightProbes),_.push(b.numLightProbeGrids),_.push(b.shadowMapType),_.push(b.toneMapping),_.push(b.numClippingPlanes),_.push(b.numClipIntersection),_.push(b.depthPacking)}function x(_,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let b=d[_.type],I;if(b){let T=Mn[b];I=Ma.clone(T.uniforms)}else I=_.uniforms;return I}function v(_,b){let I=u.get(b);return I!==void 0?++I.usedTimes:(I=new Pw(i,b,_,s),c.push(I),u.set(b,I)),I}function M(_){if(--_.usedTimes===0){let b=c.indexOf(_);c[b]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function w(_){a.remove(_)}function A(){a.dispose()}return{getParameters:p,getProgramCacheKey:g,getUniforms:y,acquireProgram:v,releaseProgram:M,releaseShaderCache:w,programs:c,dispose:A}}function Uw(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function Fw(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function bg(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Sg(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,g,m,x){let y=i[e];return y===void 0?(y={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:g,renderOrder:d.renderOrder,z:m,group:x},i[e]=y):(y.id=d.id,y.object=d,y.geometry=f,y.material=p,y.materialVariant=o(d),y.groupOrder=g,y.renderOrder=d.renderOrder,y.z=m,y.group=x),e++,y}function l(d,f,p,g,m,x,y){y.reversedDepth===!0&&(m=-m);let v=a(d,f,p,g,m,x);p.transmission>0?n.push(v):p.transparent===!0?s.push(v):t.push(v)}function c(d,f,p,g,m,x){let y=a(d,f,p,g,m,x);p.transmission>0?n.unshift(y):p.transparent===!0?s.unshift(y):t.unshift(y)}function u(d,f){t.length>1&&t.sort(d||Fw),n.length>1&&n.sort(f||bg),s.length>1&&s.sort(f||bg)}function h(){for(let d=e,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function Ow(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Sg,i.set(n,[o])):s>=r.length?(o=new Sg,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function Bw(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new C,color:new Fe};break;case"SpotLight":t={position:new C,direction:new C,color:new Fe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new C,color:new Fe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new C,skyColor:new Fe,groundColor:new Fe};break;case"RectAreaLight":t={color:new Fe,position:new C,halfWidth:new C,halfHeight:new C};break}return i[e.id]=t,t}}}function kw(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var zw=0;function Gw(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function Vw(i){let e=new Bw,t=kw(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new C);let s=new C,r=new Qe,o=new Qe;function a(c){let u=0,h=0,d=0;for(let D=0;D<9;D++)n.probe[D].set(0,0,0);let f=0,p=0,g=0,m=0,x=0,y=0,v=0,M=0,w=0,A=0,_=0,b=0,I=0,T=0;c.sort(Gw);for(let D=0,O=c.length;D<O;D++){let P=c[D],B=P.color,H=P.intensity,V=P.distance,ee=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===Ss?ee=P.shadow.map.texture:ee=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)u+=B.r*H,h+=B.g*H,d+=B.b*H;else if(P.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(P.sh.coefficients[X],H);T++}else if(P.isSunLight){let X=e.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let j=P.shadow,te=t.get(P);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),n.sunShadow[p]=te,n.sunShadowMap[p]=ee;let ve=j.getViewportCount();for(let Pe=0;Pe<ve;Pe++)n.sunShadowMatrix[g+Pe]=j.getMatrix(Pe),n.sunShadowCascade[g+Pe]=j._cascadeData[Pe];g+=ve,p++}n.sun[f]=X,f++}else if(P.isDirectionalLight){let X=e.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let j=P.shadow,te=t.get(P);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,n.directionalShadow[m]=te,n.directionalShadowMap[m]=ee,n.directionalShadowMatrix[m]=P.shadow.matrix,w++}n.directional[m]=X,m++}else if(P.isSpotLight){let X=e.get(P);X.position.setFromMatrixPosition(P.matrixWorld),X.color.copy(B).multiplyScalar(H),X.distance=V,X.coneCos=Math.cos(P.angle),X.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),X.decay=P.decay,n.spot[y]=X;let j=P.shadow;if(P.map&&(n.spotLightMap[b]=P.map,b++,j.updateMatrices(P),P.castShadow&&I++),n.spotLightMatrix[y]=j.matrix,P.castShadow){let te=t.get(P);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,n.spotShadow[y]=te,n.spotShadowMap[y]=ee,_++}y++}else if(P.isRectAreaLight){let X=e.get(P);X.color.copy(B).multiplyScalar(H),X.halfWidth.set(P.width*.5,0,0),X.halfHeight.set(0,P.height*.5,0),n.rectArea[v]=X,v++}else if(P.isPointLight){let X=e.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),X.distance=P.distance,X.decay=P.decay,P.castShadow){let j=P.shadow,te=t.get(P);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,te.shadowCameraNear=j.camera.near,te.shadowCameraFar=j.camera.far,n.pointShadow[x]=te,n.pointShadowMap[x]=ee,n.pointShadowMatrix[x]=P.shadow.matrix,A++}n.point[x]=X,x++}else if(P.isHemisphereLight){let X=e.get(P);X.skyColor.copy(P.color).multiplyScalar(H),X.groundColor.copy(P.groundColor).multiplyScalar(H),n.hemi[M]=X,M++}}v>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=fe.LTC_FLOAT_1,n.rectAreaLTC2=fe.LTC_FLOAT_2):(n.rectAreaLTC1=fe.LTC_HALF_1,n.rectAreaLTC2=fe.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=d;let L=n.hash;(L.sunLength!==f||L.directionalLength!==m||L.pointLength!==x||L.spotLength!==y||L.rectAreaLength!==v||L.hemiLength!==M||L.numSunShadows!==p||L.numDirectionalShadows!==w||L.numPointShadows!==A||L.numSpotShadows!==_||L.numSpotMaps!==b||L.numLightProbes!==T)&&(n.sun.length=f,n.directional.length=m,n.spot.length=y,n.rectArea.length=v,n.point.length=x,n.hemi.length=M,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=g,n.sunShadowCascade.length=g,n.directionalShadow.length=w,n.directionalShadowMap.length=w,n.directionalShadowMatrix.length=w,n.pointShadow.length=A,n.pointShadowMap.length=A,n.pointShadowMatrix.length=A,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+b-I,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=I,n.numLightProbes=T,L.sunLength=f,L.directionalLength=m,L.pointLength=x,L.spotLength=y,L.rectAreaLength=v,L.hemiLength=M,L.numSunShadows=p,L.numDirectionalShadows=w,L.numPointShadows=A,L.numSpotShadows=_,L.numSpotMaps=b,L.numLightProbes=T,n.version=zw++)}function l(c,u){let h=0,d=0,f=0,p=0,g=0,m=0,x=u.matrixWorldInverse;for(let y=0,v=c.length;y<v;y++){let M=c[y];if(M.isSunLight){let w=n.sun[h];w.direction.setFromMatrixPosition(M.matrixWorld),w.direction.transformDirection(x),h++}else if(M.isDirectionalLight){let w=n.directional[d];w.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),w.direction.sub(s),w.direction.transformDirection(x),d++}else if(M.isSpotLight){let w=n.spot[p];w.position.setFromMatrixPosition(M.matrixWorld),w.position.applyMatrix4(x),w.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),w.direction.sub(s),w.direction.transformDirection(x),p++}else if(M.isRectAreaLight){let w=n.rectArea[g];w.position.setFromMatrixPosition(M.matrixWorld),w.position.applyMatrix4(x),o.identity(),r.copy(M.matrixWorld),r.premultiply(x),o.extractRotation(r),w.halfWidth.set(M.width*.5,0,0),w.halfHeight.set(0,M.height*.5,0),w.halfWidth.applyMatrix4(o),w.halfHeight.applyMatrix4(o),g++}else if(M.isPointLight){let w=n.point[f];w.position.setFromMatrixPosition(M.matrixWorld),w.position.applyMatrix4(x),f++}else if(M.isHemisphereLight){let w=n.hemi[m];w.direction.setFromMatrixPosition(M.matrixWorld),w.direction.transformDirection(x),m++}}}return{setup:a,setupView:l,state:n}}function wg(i){let e=new Vw(i),t=[],n=[],s=[];function r(h){u.camera=h,t.length=0,n.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){n.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function Hw(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new wg(i),e.set(s,[a])):r>=o.length?(a=new wg(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var Ww=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,qw=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Xw=[new C(1,0,0),new C(-1,0,0),new C(0,1,0),new C(0,-1,0),new C(0,0,1),new C(0,0,-1)],$w=[new C(0,-1,0),new C(0,-1,0),new C(0,0,1),new C(0,0,-1),new C(0,-1,0),new C(0,-1,0)],Ag=new Qe,ba=new C,Gd=new C;function Yw(i,e,t){let n=new ms,s=new Ge,r=new Ge,o=new at,a=new Ql,l=new ec,c={},u=t.maxTextureSize,h={[bs]:vn,[vn]:bs,[Si]:Si},d=new Qn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ge},radius:{value:4}},vertexShader:Ww,fragmentShader:qw}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new xt;p.setAttribute("position",new Ct(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let g=new $e(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=da;let x=this.type;this.render=function(A,_,b){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;this.type===bm&&(Ie("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=da);let I=i.getRenderTarget(),T=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),D=i.state;D.setBlending(er),D.buffers.depth.getReversed()===!0?D.buffers.color.setClear(0,0,0,0):D.buffers.color.setClear(1,1,1,1),D.buffers.depth.setTest(!0),D.setScissorTest(!1);let O=x!==this.type;O&&_.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(B=>B.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,B=A.length;P<B;P++){let H=A[P],V=H.shadow;if(V===void 0){Ie("WebGLShadowMap:",H,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let ee=V.getFrameExtents();s.multiply(ee),r.copy(V.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ee.x),s.x=r.x*ee.x,V.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ee.y),s.y=r.y*ee.y,V.mapSize.y=r.y));let X=i.state.buffers.depth.getReversed();if(V.camera._reversedDepth=X,V.map===null||O===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===qr){if(H.isPointLight){Ie("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new Fn(s.x,s.y,{format:Ss,type:hi,minFilter:Ft,magFilter:Ft,generateMipmaps:!1}),V.map.texture.name=H.name+".shadowMap",V.map.depthTexture=new Xi(s.x,s.y,ei),V.map.depthTexture.name=H.name+".shadowMapDepth",V.map.depthTexture.format=qi,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=qt,V.map.depthTexture.magFilter=qt}else H.isPointLight?(V.map=new wa(s.x),V.map.depthTexture=new Ko(s.x,ui)):(V.map=new Fn(s.x,s.y),V.map.depthTexture=new Xi(s.x,s.y,ui)),V.map.depthTexture.name=H.name+".shadowMap",V.map.depthTexture.format=qi,this.type===da?(V.map.depthTexture.compareFunction=X?Rd:Td,V.map.depthTexture.minFilter=Ft,V.map.depthTexture.magFilter=Ft):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=qt,V.map.depthTexture.magFilter=qt);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let j=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();H.isPointLight!==!0&&V.updateMatrices(H,b);let te=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:b.layers;for(let ve=0;ve<j;ve++){let Pe=V.getCamera(ve);if(H.isPointLight){let Y=V.camera,ge=V.matrix,Me=H.distance||Y.far;Me!==Y.far&&(Y.far=Me,Y.updateProjectionMatrix()),ba.setFromMatrixPosition(H.matrixWorld),Y.position.copy(ba),Gd.copy(Y.position),Gd.add(Xw[ve]),Y.up.copy($w[ve]),Y.lookAt(Gd),Y.updateMatrixWorld(),ge.makeTranslation(-ba.x,-ba.y,-ba.z),Ag.multiplyMatrices(Y.projectionMatrix,Y.matrixWorldInverse),V._frustum.setFromProjectionMatrix(Ag,Y.coordinateSystem,Y.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)i.setRenderTarget(V.map,ve),i.clear();else{ve===0&&(i.setRenderTarget(V.map),i.clear());let Y=V.getViewport(ve);o.set(r.x*Y.x,r.y*Y.y,r.x*Y.z,r.y*Y.w),D.viewport(o)}n=V.getFrustum(ve),M(_,b,Pe,H,te,this.type)}V.isPointLightShadow!==!0&&this.type===qr&&y(V,b),V.needsUpdate=!1}x=this.type,m.needsUpdate=!1,i.setRenderTarget(I,T,L)};function y(A,_){let b=e.update(g);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new Fn(s.x,s.y,{format:Ss,type:hi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),d.uniforms.shadow_pass.value=A.map.depthTexture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(_,null,b,d,g,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(_,null,b,f,g,null)}function v(A,_,b,I){let T=null,L=b.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(L!==void 0)T=L;else if(T=b.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let D=T.uuid,O=_.uuid,P=c[D];P===void 0&&(P={},c[D]=P);let B=P[O];B===void 0&&(B=T.clone(),P[O]=B,_.addEventListener("dispose",w)),T=B}if(T.visible=_.visible,T.wireframe=_.wireframe,I===qr?T.side=_.shadowSide!==null?_.shadowSide:_.side:T.side=_.shadowSide!==null?_.shadowSide:h[_.side],T.alphaMap=_.alphaMap,T.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,T.map=_.map,T.clipShadows=_.clipShadows,T.clippingPlanes=_.clippingPlanes,T.clipIntersection=_.clipIntersection,T.displacementMap=_.displacementMap,T.displacementScale=_.displacementScale,T.displacementBias=_.displacementBias,T.wireframeLinewidth=_.wireframeLinewidth,T.linewidth=_.linewidth,b.isPointLight===!0&&T.isMeshDistanceMaterial===!0){let D=i.properties.get(T);D.light=b}return T}function M(A,_,b,I,T,L){if(A.visible===!1)return;if(A.layers.test(T)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&L===qr)&&(!A.frustumCulled||A.intersectsFrustum(n))){A.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,A.matrixWorld);let P=e.update(A),B=A.material;if(Array.isArray(B)){let H=P.groups;for(let V=0,ee=H.length;V<ee;V++){let X=H[V],j=B[X.materialIndex];if(j&&j.visible){let te=v(A,j,I,L);A.onBeforeShadow(i,A,_,b,P,te,X),i.renderBufferDirect(b,null,P,te,A,X),A.onAfterShadow(i,A,_,b,P,te,X)}}}else if(B.visible){let H=v(A,B,I,L);A.onBeforeShadow(i,A,_,b,P,H,null),i.renderBufferDirect(b,null,P,H,A,null),A.onAfterShadow(i,A,_,b,P,H,null)}}let O=A.children;for(let P=0,B=O.length;P<B;P++)M(O[P],_,b,I,T,L)}function w(A){A.target.removeEventListener("dispose",w);for(let b in c){let I=c[b],T=A.target.uuid;T in I&&(I[T].dispose(),delete I[T])}}}function Zw(i,e){function t(){let N=!1,J=new at,$=null,le=new at(0,0,0,0);return{setMask:function(se){$!==se&&!N&&(i.colorMask(se,se,se,se),$=se)},setLocked:function(se){N=se},setClear:function(se,oe,Re,qe,ie){ie===!0&&(se*=qe,oe*=qe,Re*=qe),J.set(se,oe,Re,qe),le.equals(J)===!1&&(i.clearColor(se,oe,Re,qe),le.copy(J))},reset:function(){N=!1,$=null,le.set(-1,0,0,0)}}}function n(){let N=!1,J=!1,$=null,le=null,se=null;return{setReversed:function(oe){if(J!==oe){let Re=e.get("EXT_clip_control");oe?Re.clipControlEXT(Re.LOWER_LEFT_EXT,Re.ZERO_TO_ONE_EXT):Re.clipControlEXT(Re.LOWER_LEFT_EXT,Re.NEGATIVE_ONE_TO_ONE_EXT),J=oe;let qe=se;se=null,this.setClear(qe)}},getReversed:function(){return J},setTest:function(oe){oe?ye(i.DEPTH_TEST):ze(i.DEPTH_TEST)},setMask:function(oe){$!==oe&&!N&&(i.depthMask(oe),$=oe)},setFunc:function(oe){if(J&&(oe=tg[oe]),le!==oe){switch(oe){case Ul:i.depthFunc(i.NEVER);break;case Fl:i.depthFunc(i.ALWAYS);break;case Ol:i.depthFunc(i.LESS);break;case Nr:i.depthFunc(i.LEQUAL);break;case Bl:i.depthFunc(i.EQUAL);break;case kl:i.depthFunc(i.GEQUAL);break;case zl:i.depthFunc(i.GREATER);break;case Gl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}le=oe}},setLocked:function(oe){N=oe},setClear:function(oe){se!==oe&&(se=oe,J&&(oe=1-oe),i.clearDepth(oe))},reset:function(){N=!1,$=null,le=null,se=null,J=!1}}}function s(){let N=!1,J=null,$=null,le=null,se=null,oe=null,Re=null,qe=null,ie=null;return{setTest:function(Ce){N||(Ce?ye(i.STENCIL_TEST):ze(i.STENCIL_TEST))},setMask:function(Ce){J!==Ce&&!N&&(i.stencilMask(Ce),J=Ce)},setFunc:function(Ce,We,xe){($!==Ce||le!==We||se!==xe)&&(i.stencilFunc(Ce,We,xe),$=Ce,le=We,se=xe)},setOp:function(Ce,We,xe){(oe!==Ce||Re!==We||qe!==xe)&&(i.stencilOp(Ce,We,xe),oe=Ce,Re=We,qe=xe)},setLocked:function(Ce){N=Ce},setClear:function(Ce){ie!==Ce&&(i.clearStencil(Ce),ie=Ce)},reset:function(){N=!1,J=null,$=null,le=null,se=null,oe=null,Re=null,qe=null,ie=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],g=null,m=!1,x=null,y=null,v=null,M=null,w=null,A=null,_=null,b=new Fe(0,0,0),I=0,T=!1,L=null,D=null,O=null,P=null,B=null,H=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ee=0,X=i.getParameter(i.VERSION);X.indexOf("WebGL")!==-1?(ee=parseFloat(/^WebGL (\d)/.exec(X)[1]),V=ee>=1):X.indexOf("OpenGL ES")!==-1&&(ee=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),V=ee>=2);let j=null,te={},ve=i.getParameter(i.SCISSOR_BOX),Pe=i.getParameter(i.VIEWPORT),Y=new at().fromArray(ve),ge=new at().fromArray(Pe);function Me(N,J,$,le){let se=new Uint8Array(4),oe=i.createTexture();i.bindTexture(N,oe),i.texParameteri(N,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(N,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Re=0;Re<$;Re++)N===i.TEXTURE_3D||N===i.TEXTURE_2D_ARRAY?i.texImage3D(J,0,i.RGBA,1,1,le,0,i.RGBA,i.UNSIGNED_BYTE,se):i.texImage2D(J+Re,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,se);return oe}let Le={};Le[i.TEXTURE_2D]=Me(i.TEXTURE_2D,i.TEXTURE_2D,1),Le[i.TEXTURE_CUBE_MAP]=Me(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Le[i.TEXTURE_2D_ARRAY]=Me(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Le[i.TEXTURE_3D]=Me(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ye(i.DEPTH_TEST),o.setFunc(Nr),En(!1),Tt(ad),ye(i.CULL_FACE),Jt(er);function ye(N){u[N]!==!0&&(i.enable(N),u[N]=!0)}function ze(N){u[N]!==!1&&(i.disable(N),u[N]=!1)}function Pt(N,J){return d[N]!==J?(i.bindFramebuffer(N,J),d[N]=J,N===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=J),N===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=J),!0):!1}function De(N,J){let $=p,le=!1;if(N){$=f.get(J),$===void 0&&($=[],f.set(J,$));let se=N.textures;if($.length!==se.length||$[0]!==i.COLOR_ATTACHMENT0){for(let oe=0,Re=se.length;oe<Re;oe++)$[oe]=i.COLOR_ATTACHMENT0+oe;$.length=se.length,le=!0}}else $[0]!==i.BACK&&($[0]=i.BACK,le=!0);le&&i.drawBuffers($)}function lt(N){return g!==N?(i.useProgram(N),g=N,!0):!1}let ft={[tr]:i.FUNC_ADD,[wm]:i.FUNC_SUBTRACT,[Am]:i.FUNC_REVERSE_SUBTRACT};ft[Em]=i.MIN,ft[Tm]=i.MAX;let Ye={[Rm]:i.ZERO,[Cm]:i.ONE,[Im]:i.SRC_COLOR,[hd]:i.SRC_ALPHA,[Fm]:i.SRC_ALPHA_SATURATE,[Dm]:i.DST_COLOR,[Lm]:i.DST_ALPHA,[Pm]:i.ONE_MINUS_SRC_COLOR,[dd]:i.ONE_MINUS_SRC_ALPHA,[Um]:i.ONE_MINUS_DST_COLOR,[Nm]:i.ONE_MINUS_DST_ALPHA,[Om]:i.CONSTANT_COLOR,[Bm]:i.ONE_MINUS_CONSTANT_COLOR,[km]:i.CONSTANT_ALPHA,[zm]:i.ONE_MINUS_CONSTANT_ALPHA};function Jt(N,J,$,le,se,oe,Re,qe,ie,Ce){if(N===er){m===!0&&(ze(i.BLEND),m=!1);return}if(m===!1&&(ye(i.BLEND),m=!0),N!==Sm){if(N!==x||Ce!==T){if((y!==tr||w!==tr)&&(i.blendEquation(i.FUNC_ADD),y=tr,w=tr),Ce)switch(N){case Xr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ld:i.blendFunc(i.ONE,i.ONE);break;case cd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case ud:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Ue("WebGLState: Invalid blending: ",N);break}else switch(N){case Xr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ld:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case cd:Ue("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ud:Ue("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ue("WebGLState: Invalid blending: ",N);break}v=null,M=null,A=null,_=null,b.set(0,0,0),I=0,x=N,T=Ce}return}se=se||J,oe=oe||$,Re=Re||le,(J!==y||se!==w)&&(i.blendEquationSeparate(ft[J],ft[se]),y=J,w=se),($!==v||le!==M||oe!==A||Re!==_)&&(i.blendFuncSeparate(Ye[$],Ye[le],Ye[oe],Ye[Re]),v=$,M=le,A=oe,_=Re),(qe.equals(b)===!1||ie!==I)&&(i.blendColor(qe.r,qe.g,qe.b,ie),b.copy(qe),I=ie),x=N,T=!1}function Dt(N,J){N.side===Si?ze(i.CULL_FACE):ye(i.CULL_FACE);let $=N.side===vn;J&&($=!$),En($),N.blending===Xr&&N.transparent===!1?Jt(er):Jt(N.blending,N.blendEquation,N.blendSrc,N.blendDst,N.blendEquationAlpha,N.blendSrcAlpha,N.blendDstAlpha,N.blendColor,N.blendAlpha,N.premultipliedAlpha),o.setFunc(N.depthFunc),o.setTest(N.depthTest),o.setMask(N.depthWrite),r.setMask(N.colorWrite);let le=N.stencilWrite;a.setTest(le),le&&(a.setMask(N.stencilWriteMask),a.setFunc(N.stencilFunc,N.stencilRef,N.stencilFuncMask),a.setOp(N.stencilFail,N.stencilZFail,N.stencilZPass)),Gt(N.polygonOffset,N.polygonOffsetFactor,N.polygonOffsetUnits),N.alphaToCoverage===!0?ye(i.SAMPLE_ALPHA_TO_COVERAGE):ze(i.SAMPLE_ALPHA_TO_COVERAGE)}function En(N){L!==N&&(N?i.frontFace(i.CW):i.frontFace(i.CCW),L=N)}function Tt(N){N!==vm?(ye(i.CULL_FACE),N!==D&&(N===ad?i.cullFace(i.BACK):N===Mm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):ze(i.CULL_FACE),D=N}function yi(N){N!==O&&(V&&i.lineWidth(N),O=N)}function Gt(N,J,$){N?(ye(i.POLYGON_OFFSET_FILL),(P!==J||B!==$)&&(P=J,B=$,o.getReversed()&&(J=-J,$=-$),i.polygonOffset(J,$))):ze(i.POLYGON_OFFSET_FILL)}function qn(N){N?ye(i.SCISSOR_TEST):ze(i.SCISSOR_TEST)}function Xn(N){N===void 0&&(N=i.TEXTURE0+H-1),j!==N&&(i.activeTexture(N),j=N)}function $n(N,J,$){$===void 0&&(j===null?$=i.TEXTURE0+H-1:$=j);let le=te[$];le===void 0&&(le={type:void 0,texture:void 0},te[$]=le),(le.type!==N||le.texture!==J)&&(j!==$&&(i.activeTexture($),j=$),i.bindTexture(N,J||Le[N]),le.type=N,le.texture=J)}function F(){let N=te[j];N!==void 0&&N.type!==void 0&&(i.bindTexture(N.type,null),N.type=void 0,N.texture=void 0)}function Yn(){try{i.compressedTexImage2D(...arguments)}catch(N){Ue("WebGLState:",N)}}function St(){try{i.compressedTexImage3D(...arguments)}catch(N){Ue("WebGLState:",N)}}function wt(){try{i.texSubImage2D(...arguments)}catch(N){Ue("WebGLState:",N)}}function pe(){try{i.texSubImage3D(...arguments)}catch(N){Ue("WebGLState:",N)}}function Ut(){try{i.compressedTexSubImage2D(...arguments)}catch(N){Ue("WebGLState:",N)}}function Ne(){try{i.compressedTexSubImage3D(...arguments)}catch(N){Ue("WebGLState:",N)}}function Be(){try{i.texStorage2D(...arguments)}catch(N){Ue("WebGLState:",N)}}function R(){try{i.texStorage3D(...arguments)}catch(N){Ue("WebGLState:",N)}}function S(){try{i.texImage2D(...arguments)}catch(N){Ue("WebGLState:",N)}}function z(){try{i.texImage3D(...arguments)}catch(N){Ue("WebGLState:",N)}}function ne(N){return h[N]!==void 0?h[N]:i.getParameter(N)}function Q(N,J){h[N]!==J&&(i.pixelStorei(N,J),h[N]=J)}function re(N){Y.equals(N)===!1&&(i.scissor(N.x,N.y,N.z,N.w),Y.copy(N))}function ue(N){ge.equals(N)===!1&&(i.viewport(N.x,N.y,N.z,N.w),ge.copy(N))}function Z(N,J){let $=c.get(J);$===void 0&&($=new WeakMap,c.set(J,$));let le=$.get(N);le===void 0&&(le=i.getUniformBlockIndex(J,N.name),i.uniformBlockBinding(J,le,le),$.set(N,le))}function K(N,J,$){let se=c.get(J).get(N);l[se]!==$&&(i.bindBufferBase(i.UNIFORM_BUFFER,se,$),l[se]=$)}function ae(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},h={},j=null,te={},d={},l={},f=new WeakMap,p=[],g=null,m=!1,x=null,y=null,v=null,M=null,w=null,A=null,_=null,b=new Fe(0,0,0),I=0,T=!1,L=null,D=null,O=null,P=null,B=null,Y.set(0,0,i.canvas.width,i.canvas.height),ge.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ye,disable:ze,bindFramebuffer:Pt,drawBuffers:De,useProgram:lt,setBlending:Jt,setMaterial:Dt,setFlipSided:En,setCullFace:Tt,setLineWidth:yi,setPolygonOffset:Gt,setScissorTest:qn,activeTexture:Xn,bindTexture:$n,unbindTexture:F,compressedTexImage2D:Yn,compressedTexImage3D:St,texImage2D:S,texImage3D:z,pixelStorei:Q,getParameter:ne,updateUBOMapping:Z,uniformBlockBinding:K,texStorage2D:Be,texStorage3D:R,texSubImage2D:wt,texSubImage3D:pe,compressedTexSubImage2D:Ut,compressedTexSubImage3D:Ne,scissor:re,viewport:ue,reset:ae}}function jw(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ge,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,g=new FinalizationRegistry(R=>p.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function x(R,S){return m?new OffscreenCanvas(R,S):zo("canvas")}function y(R,S,z){let ne=1,Q=Be(R);if((Q.width>z||Q.height>z)&&(ne=z/Math.max(Q.width,Q.height)),ne<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let re=Math.floor(ne*Q.width),ue=Math.floor(ne*Q.height);d===void 0&&(d=x(re,ue));let Z=S?x(re,ue):d;return Z.width=re,Z.height=ue,Z.getContext("2d").drawImage(R,0,0,re,ue),Ie("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+re+"x"+ue+")."),Z}else return"data"in R&&Ie("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),R;return R}function v(R){return R.generateMipmaps}function M(R){i.generateMipmap(R)}function w(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(R,S,z,ne,Q,re=!1){if(R!==null){if(i[R]!==void 0)return i[R];Ie("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ue;ne&&(ue=e.get("EXT_texture_norm16"),ue||Ie("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=S;if(S===i.RED&&(z===i.FLOAT&&(Z=i.R32F),z===i.HALF_FLOAT&&(Z=i.R16F),z===i.UNSIGNED_BYTE&&(Z=i.R8),z===i.UNSIGNED_SHORT&&ue&&(Z=ue.R16_EXT),z===i.SHORT&&ue&&(Z=ue.R16_SNORM_EXT)),S===i.RED_INTEGER&&(z===i.UNSIGNED_BYTE&&(Z=i.R8UI),z===i.UNSIGNED_SHORT&&(Z=i.R16UI),z===i.UNSIGNED_INT&&(Z=i.R32UI),z===i.BYTE&&(Z=i.R8I),z===i.SHORT&&(Z=i.R16I),z===i.INT&&(Z=i.R32I)),S===i.RG&&(z===i.FLOAT&&(Z=i.RG32F),z===i.HALF_FLOAT&&(Z=i.RG16F),z===i.UNSIGNED_BYTE&&(Z=i.RG8),z===i.UNSIGNED_SHORT&&ue&&(Z=ue.RG16_EXT),z===i.SHORT&&ue&&(Z=ue.RG16_SNORM_EXT)),S===i.RG_INTEGER&&(z===i.UNSIGNED_BYTE&&(Z=i.RG8UI),z===i.UNSIGNED_SHORT&&(Z=i.RG16UI),z===i.UNSIGNED_INT&&(Z=i.RG32UI),z===i.BYTE&&(Z=i.RG8I),z===i.SHORT&&(Z=i.RG16I),z===i.INT&&(Z=i.RG32I)),S===i.RGB_INTEGER&&(z===i.UNSIGNED_BYTE&&(Z=i.RGB8UI),z===i.UNSIGNED_SHORT&&(Z=i.RGB16UI),z===i.UNSIGNED_INT&&(Z=i.RGB32UI),z===i.BYTE&&(Z=i.RGB8I),z===i.SHORT&&(Z=i.RGB16I),z===i.INT&&(Z=i.RGB32I)),S===i.RGBA_INTEGER&&(z===i.UNSIGNED_BYTE&&(Z=i.RGBA8UI),z===i.UNSIGNED_SHORT&&(Z=i.RGBA16UI),z===i.UNSIGNED_INT&&(Z=i.RGBA32UI),z===i.BYTE&&(Z=i.RGBA8I),z===i.SHORT&&(Z=i.RGBA16I),z===i.INT&&(Z=i.RGBA32I)),S===i.RGB&&(z===i.UNSIGNED_SHORT&&ue&&(Z=ue.RGB16_EXT),z===i.SHORT&&ue&&(Z=ue.RGB16_SNORM_EXT),z===i.UNSIGNED_INT_5_9_9_9_REV&&(Z=i.RGB9_E5),z===i.UNSIGNED_INT_10F_11F_11F_REV&&(Z=i.R11F_G11F_B10F)),S===i.RGBA){let K=re?ko:Ke.getTransfer(Q);z===i.FLOAT&&(Z=i.RGBA32F),z===i.HALF_FLOAT&&(Z=i.RGBA16F),z===i.UNSIGNED_BYTE&&(Z=K===rt?i.SRGB8_ALPHA8:i.RGBA8),z===i.UNSIGNED_SHORT&&ue&&(Z=ue.RGBA16_EXT),z===i.SHORT&&ue&&(Z=ue.RGBA16_SNORM_EXT),z===i.UNSIGNED_SHORT_4_4_4_4&&(Z=i.RGBA4),z===i.UNSIGNED_SHORT_5_5_5_1&&(Z=i.RGB5_A1)}return(Z===i.R16F||Z===i.R32F||Z===i.RG16F||Z===i.RG32F||Z===i.RGBA16F||Z===i.RGBA32F)&&e.get("EXT_color_buffer_float"),Z}function _(R,S){let z;return R?S===null||S===ui||S===ir?z=i.DEPTH24_STENCIL8:S===ei?z=i.DEPTH32F_STENCIL8:S===Yr&&(z=i.DEPTH24_STENCIL8,Ie("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===ui||S===ir?z=i.DEPTH_COMPONENT24:S===ei?z=i.DEPTH_COMPONENT32F:S===Yr&&(z=i.DEPTH_COMPONENT16),z}function b(R,S){return v(R)===!0||R.isFramebufferTexture&&R.minFilter!==qt&&R.minFilter!==Ft?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function I(R){let S=new WeakRef(R);n.get(R).__ref=S,p.add(S),g.register(R,S,S)}function T(R){let S=n.get(R).__ref;S!==void 0&&(p.delete(S),g.unregister(S))}function L(R){O(R.target)}function D(R){P(R.target)}function O(R){R.removeEventListener("dispose",L),T(R),H(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&h.delete(R)}function P(R){R.removeEventListener("dispose",D),T(R),ee(R)}function B(){for(let R of p){let S=R.deref();S!==void 0&&(S.isRenderTarget===!0?P(S):O(S))}p.clear(),h.clear()}function H(R){let S=n.get(R);if(S.__webglInit===void 0)return;let z=R.source,ne=f.get(z);if(ne){let Q=ne[S.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&V(R),Object.keys(ne).length===0&&f.delete(z)}n.remove(R)}function V(R){let S=n.get(R);i.deleteTexture(S.__webglTexture);let z=R.source,ne=f.get(z);delete ne[S.__cacheKey],o.memory.textures--}function ee(R){let S=n.get(R);S.__depthDisposeCallback&&S.__depthDisposeCallback();let z=R.depthTexture;if(z&&z.renderTarget===R&&O(z),R.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(S.__webglFramebuffer[Q]))for(let re=0;re<S.__webglFramebuffer[Q].length;re++)i.deleteFramebuffer(S.__webglFramebuffer[Q][re]);else i.deleteFramebuffer(S.__webglFramebuffer[Q]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[Q])}else{if(Array.isArray(S.__webglFramebuffer))for(let Q=0;Q<S.__webglFramebuffer.length;Q++)i.deleteFramebuffer(S.__webglFramebuffer[Q]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let Q=0;Q<S.__webglColorRenderbuffer.length;Q++)S.__webglColorRenderbuffer[Q]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[Q]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ne=R.textures;for(let Q=0,re=ne.length;Q<re;Q++){let ue=n.get(ne[Q]);ue.__webglTexture&&(i.deleteTexture(ue.__webglTexture),o.memory.textures--),n.remove(ne[Q])}n.remove(R)}let X=0;function j(){X=0}function te(){return X}function ve(R){X=R}function Pe(){let R=X;return R>=s.maxTextures&&Ie("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,R}function Y(R){let S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.mipmapsAutoUpdate),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function ge(R,S){let z=n.get(R);if(R.isVideoTexture&&Ut(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&z.__version!==R.version){let ne=R.image;if(ne===null)Ie("WebGLRenderer: Texture marked for update but no image data found.");else if(ne.complete===!1)Ie("WebGLRenderer: Texture marked for update but image is incomplete");else{Dt(z,R,S);return}}else R.isExternalTexture&&(z.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,z.__webglTexture,i.TEXTURE0+S)}function Me(R,S){let z=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&z.__version!==R.version){Dt(z,R,S);return}else R.isExternalTexture&&(z.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,z.__webglTexture,i.TEXTURE0+S)}function Le(R,S){let z=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&z.__version!==R.version){Dt(z,R,S);return}t.bindTexture(i.TEXTURE_3D,z.__webglTexture,i.TEXTURE0+S)}function ye(R,S){let z=n.get(R);if(R.version>0&&z.__version!==R.version){En(z,R,S);return}t.bindTexture(i.TEXTURE_CUBE_MAP,z.__webglTexture,i.TEXTURE0+S)}let ze={[Vl]:i.REPEAT,[vi]:i.CLAMP_TO_EDGE,[Hl]:i.MIRRORED_REPEAT},Pt={[qt]:i.NEAREST,[Hm]:i.NEAREST_MIPMAP_NEAREST,[pa]:i.NEAREST_MIPMAP_LINEAR,[Ft]:i.LINEAR,[mc]:i.LINEAR_MIPMAP_NEAREST,[Yi]:i.LINEAR_MIPMAP_LINEAR},De={[$m]:i.NEVER,[Cd]:i.ALWAYS,[Ym]:i.LESS,[Td]:i.LEQUAL,[Zm]:i.EQUAL,[Rd]:i.GEQUAL,[jm]:i.GREATER,[Km]:i.NOTEQUAL};function lt(R,S){if(S.type===ei&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===Ft||S.magFilter===mc||S.magFilter===pa||S.magFilter===Yi||S.minFilter===Ft||S.minFilter===mc||S.minFilter===pa||S.minFilter===Yi)&&Ie("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,ze[S.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,ze[S.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,ze[S.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,Pt[S.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,Pt[S.minFilter]),S.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,De[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===qt||S.minFilter!==pa&&S.minFilter!==Yi||S.type===ei&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let z=e.get("EXT_texture_filter_anisotropic");i.texParameterf(R,z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function ft(R,S){let z=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",L),I(S));let ne=S.source,Q=f.get(ne);Q===void 0&&(Q={},f.set(ne,Q));let re=Y(S);if(re!==R.__cacheKey){Q[re]===void 0&&(Q[re]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,z=!0),Q[re].usedTimes++;let ue=Q[R.__cacheKey];ue!==void 0&&(Q[R.__cacheKey].usedTimes--,ue.usedTimes===0&&V(S)),R.__cacheKey=re,R.__webglTexture=Q[re].texture}return z}function Ye(R,S,z){return Math.floor(Math.floor(R/z)/S)}function Jt(R,S,z,ne){let re=R.updateRanges;if(re.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,z,ne,S.data);else{re.sort((N,J)=>N.start-J.start);let ue=0;for(let N=1;N<re.length;N++){let J=re[ue],$=re[N],le=J.start+J.count,se=Ye($.start,S.width,4),oe=Ye(J.start,S.width,4);$.start<=le+1&&se===oe&&Ye($.start+$.count-1,S.width,4)===se?J.count=Math.max(J.count,$.start+$.count-J.start):(++ue,re[ue]=$)}re.length=ue+1;let Z=t.getParameter(i.UNPACK_ROW_LENGTH),K=t.getParameter(i.UNPACK_SKIP_PIXELS),ae=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let N=0,J=re.length;N<J;N++){let $=re[N],le=Math.floor($.start/4),se=Math.ceil($.count/4),oe=le%S.width,Re=Math.floor(le/S.width),qe=se,ie=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,oe),t.pixelStorei(i.UNPACK_SKIP_ROWS,Re),t.texSubImage2D(i.TEXTURE_2D,0,oe,Re,qe,ie,z,ne,S.data)}R.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,Z),t.pixelStorei(i.UNPACK_SKIP_PIXELS,K),t.pixelStorei(i.UNPACK_SKIP_ROWS,ae)}}function Dt(R,S,z){let ne=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ne=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ne=i.TEXTURE_3D);let Q=ft(R,S),re=S.source;t.bindTexture(ne,R.__webglTexture,i.TEXTURE0+z);let ue=n.get(re);if(re.version!==ue.__version||Q===!0){if(t.activeTexture(i.TEXTURE0+z),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ie=Ke.getPrimaries(Ke.workingColorSpace),Ce=S.colorSpace===ji?null:Ke.getPrimaries(S.colorSpace),We=S.colorSpace===ji||ie===Ce?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,We)}t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let K=y(S.image,!1,s.maxTextureSize);K=Ne(S,K);let ae=r.convert(S.format,S.colorSpace),N=r.convert(S.type),J=A(S.internalFormat,ae,N,S.normalized,S.colorSpace,S.isVideoTexture);lt(ne,S);let $,le=S.mipmaps,se=S.isVideoTexture!==!0,oe=ue.__version===void 0||Q===!0,Re=re.dataReady,qe=b(S,K);if(S.isDepthTexture)J=_(S.format===Zi,S.type),oe&&(se?t.texStorage2D(i.TEXTURE_2D,1,J,K.width,K.height):t.texImage2D(i.TEXTURE_2D,0,J,K.width,K.height,0,ae,N,null));else if(S.isDataTexture)if(le.length>0){se&&oe&&t.texStorage2D(i.TEXTURE_2D,qe,J,le[0].width,le[0].height);for(let ie=0,Ce=le.length;ie<Ce;ie++)$=le[ie],se?Re&&t.texSubImage2D(i.TEXTURE_2D,ie,0,0,$.width,$.height,ae,N,$.data):t.texImage2D(i.TEXTURE_2D,ie,J,$.width,$.height,0,ae,N,$.data);S.generateMipmaps=!1}else se?(oe&&t.texStorage2D(i.TEXTURE_2D,qe,J,K.width,K.height),Re&&Jt(S,K,ae,N)):t.texImage2D(i.TEXTURE_2D,0,J,K.width,K.height,0,ae,N,K.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){se&&oe&&t.texStorage3D(i.TEXTURE_2D_ARRAY,qe,J,le[0].width,le[0].height,K.depth);for(let ie=0,Ce=le.length;ie<Ce;ie++)if($=le[ie],S.format!==di)if(ae!==null)if(se){if(Re)if(S.layerUpdates.size>0){let We=kd($.width,$.height,S.format,S.type);for(let xe of S.layerUpdates){let ct=$.data.subarray(xe*We/$.data.BYTES_PER_ELEMENT,(xe+1)*We/$.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ie,0,0,xe,$.width,$.height,1,ae,ct)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ie,0,0,0,$.width,$.height,K.depth,ae,$.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ie,J,$.width,$.height,K.depth,0,$.data,0,0);else Ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else se?Re&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ie,0,0,0,$.width,$.height,K.depth,ae,N,$.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ie,J,$.width,$.height,K.depth,0,ae,N,$.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{se&&oe&&t.texStorage2D(i.TEXTURE_2D,qe,J,le[0].width,le[0].height);for(let ie=0,Ce=le.length;ie<Ce;ie++)$=le[ie],S.format!==di?ae!==null?se?Re&&t.compressedTexSubImage2D(i.TEXTURE_2D,ie,0,0,$.width,$.height,ae,$.data):t.compressedTexImage2D(i.TEXTURE_2D,ie,J,$.width,$.height,0,$.data):Ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):se?Re&&t.texSubImage2D(i.TEXTURE_2D,ie,0,0,$.width,$.height,ae,N,$.data):t.texImage2D(i.TEXTURE_2D,ie,J,$.width,$.height,0,ae,N,$.data)}else if(S.isDataArrayTexture)if(se){if(oe&&t.texStorage3D(i.TEXTURE_2D_ARRAY,qe,J,K.width,K.height,K.depth),Re)if(S.layerUpdates.size>0){let ie=kd(K.width,K.height,S.format,S.type);for(let Ce of S.layerUpdates){let We=K.data.subarray(Ce*ie/K.data.BYTES_PER_ELEMENT,(Ce+1)*ie/K.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ce,K.width,K.height,1,ae,N,We)}S.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,K.width,K.height,K.depth,ae,N,K.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,J,K.width,K.height,K.depth,0,ae,N,K.data);else if(S.isData3DTexture)se?(oe&&t.texStorage3D(i.TEXTURE_3D,qe,J,K.width,K.height,K.depth),Re&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,K.width,K.height,K.depth,ae,N,K.data)):t.texImage3D(i.TEXTURE_3D,0,J,K.width,K.height,K.depth,0,ae,N,K.data);else if(S.isFramebufferTexture){if(oe)if(se)t.texStorage2D(i.TEXTURE_2D,qe,J,K.width,K.height);else{let ie=K.width,Ce=K.height;for(let We=0;We<qe;We++)t.texImage2D(i.TEXTURE_2D,We,J,ie,Ce,0,ae,N,null),ie>>=1,Ce>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let ie=i.canvas;if(ie.hasAttribute("layoutsubtree")||ie.setAttribute("layoutsubtree","true"),K.parentNode!==ie){ie.appendChild(K),h.add(S),ie.onpaint=Ce=>{let We=Ce.changedElements;for(let xe of h)We.includes(xe.image)&&(xe.needsUpdate=!0)},ie.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,K);else{let We=i.RGBA,xe=i.RGBA,ct=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,We,xe,ct,K)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(le.length>0){if(se&&oe){let ie=Be(le[0]);t.texStorage2D(i.TEXTURE_2D,qe,J,ie.width,ie.height)}for(let ie=0,Ce=le.length;ie<Ce;ie++)$=le[ie],se?Re&&t.texSubImage2D(i.TEXTURE_2D,ie,0,0,ae,N,$):t.texImage2D(i.TEXTURE_2D,ie,J,ae,N,$);S.generateMipmaps=!1}else if(se){if(oe){let ie=Be(K);t.texStorage2D(i.TEXTURE_2D,qe,J,ie.width,ie.height)}Re&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ae,N,K)}else t.texImage2D(i.TEXTURE_2D,0,J,ae,N,K);v(S)&&S.mipmapsAutoUpdate===!0&&M(ne),ue.__version=re.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function En(R,S,z){if(S.image.length!==6)return;let ne=ft(R,S),Q=S.source;t.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+z);let re=n.get(Q);if(Q.version!==re.__version||ne===!0){t.activeTexture(i.TEXTURE0+z);let ue=Ke.getPrimaries(Ke.workingColorSpace),Z=S.colorSpace===ji?null:Ke.getPrimaries(S.colorSpace),K=S.colorSpace===ji||ue===Z?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,K);let ae=S.isCompressedTexture||S.image[0].isCompressedTexture,N=S.image[0]&&S.image[0].isDataTexture,J=[];for(let xe=0;xe<6;xe++)!ae&&!N?J[xe]=y(S.image[xe],!0,s.maxCubemapSize):J[xe]=N?S.image[xe].image:S.image[xe],J[xe]=Ne(S,J[xe]);let $=J[0],le=r.convert(S.format,S.colorSpace),se=r.convert(S.type),oe=A(S.internalFormat,le,se,S.normalized,S.colorSpace),Re=S.isVideoTexture!==!0,qe=re.__version===void 0||ne===!0,ie=Q.dataReady,Ce=b(S,$);lt(i.TEXTURE_CUBE_MAP,S);let We;if(S.isDepthTexture){if(oe=_(S.format===Zi,S.type),qe)if(Re)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,oe,$.width,$.height);else for(let xe=0;xe<6;xe++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,0,oe,$.width,$.height,0,le,se,null)}else if(ae){Re&&qe&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ce,oe,$.width,$.height);for(let xe=0;xe<6;xe++){We=J[xe].mipmaps;for(let ct=0;ct<We.length;ct++){let Vt=We[ct];S.format!==di?le!==null?Re?ie&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,ct,0,0,Vt.width,Vt.height,le,Vt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,ct,oe,Vt.width,Vt.height,0,Vt.data):Ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Re?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,ct,0,0,Vt.width,Vt.height,le,se,Vt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,ct,oe,Vt.width,Vt.height,0,le,se,Vt.data)}}}else{if(We=S.mipmaps,Re&&qe){We.length>0&&Ce++;let xe=Be(J[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ce,oe,xe.width,xe.height)}for(let xe=0;xe<6;xe++)if(N){Re?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,0,0,0,J[xe].width,J[xe].height,le,se,J[xe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,0,oe,J[xe].width,J[xe].height,0,le,se,J[xe].data);for(let ct=0;ct<We.length;ct++){let as=We[ct].image[xe].image;Re?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,ct+1,0,0,as.width,as.height,le,se,as.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,ct+1,oe,as.width,as.height,0,le,se,as.data)}}else{Re?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,0,0,0,le,se,J[xe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,0,oe,le,se,J[xe]);for(let ct=0;ct<We.length;ct++){let Vt=We[ct];Re?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,ct+1,0,0,le,se,Vt.image[xe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,ct+1,oe,le,se,Vt.image[xe])}}}v(S)&&S.mipmapsAutoUpdate===!0&&M(i.TEXTURE_CUBE_MAP),re.__version=Q.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function Tt(R,S,z,ne,Q,re){let ue=r.convert(z.format,z.colorSpace),Z=r.convert(z.type),K=A(z.internalFormat,ue,Z,z.normalized,z.colorSpace),ae=n.get(S),N=n.get(z);if(N.__renderTarget=S,!ae.__hasExternalTextures){let J=Math.max(1,S.width>>re),$=Math.max(1,S.height>>re);Q===i.TEXTURE_3D||Q===i.TEXTURE_2D_ARRAY?t.texImage3D(Q,re,K,J,$,S.depth,0,ue,Z,null):t.texImage2D(Q,re,K,J,$,0,ue,Z,null)}t.bindFramebuffer(i.FRAMEBUFFER,R),pe(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ne,Q,N.__webglTexture,0,wt(S)):(Q===i.TEXTURE_2D||Q>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ne,Q,N.__webglTexture,re),t.bindFramebuffer(i.FRAMEBUFFER,null)}function yi(R,S,z){if(i.bindRenderbuffer(i.RENDERBUFFER,R),S.depthBuffer){let ne=S.depthTexture,Q=ne&&ne.isDepthTexture?ne.type:null,re=_(S.stencilBuffer,Q),ue=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;pe(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,wt(S),re,S.width,S.height):z?i.renderbufferStorageMultisample(i.RENDERBUFFER,wt(S),re,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,re,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ue,i.RENDERBUFFER,R)}else{let ne=S.textures;for(let Q=0;Q<ne.length;Q++){let re=ne[Q],ue=r.convert(re.format,re.colorSpace),Z=r.convert(re.type),K=A(re.internalFormat,ue,Z,re.normalized,re.colorSpace);pe(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,wt(S),K,S.width,S.height):z?i.renderbufferStorageMultisample(i.RENDERBUFFER,wt(S),K,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,K,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Gt(R,S,z){let ne=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Q=n.get(S.depthTexture);Q.__renderTarget=S;let re=ne?S.depthTexture.image[0]:S.depthTexture.image;(!Q.__webglTexture||re.width!==S.width||re.height!==S.height)&&(re.width=S.width,re.height=S.height,S.depthTexture.needsUpdate=!0),ne?ye(S.depthTexture,0):ge(S.depthTexture,0);let ue=Q.__webglTexture,Z=wt(S),K=ne?i.TEXTURE_CUBE_MAP_POSITIVE_X+z:i.TEXTURE_2D,ae=S.depthTexture.format===Zi?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===qi)pe(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ae,K,ue,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,ae,K,ue,0);else if(S.depthTexture.format===Zi)pe(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ae,K,ue,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,ae,K,ue,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function qn(R){let S=n.get(R),z=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){let ne=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ne){let Q=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ne.removeEventListener("dispose",Q)};ne.addEventListener("dispose",Q),S.__depthDisposeCallback=Q}S.__boundDepthTexture=ne}if(R.depthTexture&&!S.__autoAllocateDepthBuffer)if(z)for(let ne=0;ne<6;ne++)Gt(S.__webglFramebuffer[ne],R,ne);else R.texture.mipmaps.length>0?Gt(S.__webglFramebuffer[0],R,0):Gt(S.__webglFramebuffer,R,0);else if(z){S.__webglDepthbuffer=[];for(let ne=0;ne<6;ne++)if(t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[ne]),S.__webglDepthbuffer[ne]===void 0)S.__webglDepthbuffer[ne]=i.createRenderbuffer(),yi(S.__webglDepthbuffer[ne],R,!1);else{let Q=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,re=S.__webglDepthbuffer[ne];i.bindRenderbuffer(i.RENDERBUFFER,re),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,re)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),yi(S.__webglDepthbuffer,R,!1);else{let Q=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,re=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,re),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,re)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Xn(R,S,z){let ne=n.get(R);S!==void 0&&Tt(ne.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),z!==void 0&&qn(R)}function $n(R){let S=R.texture,z=n.get(R),ne=n.get(S);R.addEventListener("dispose",D),I(R);let Q=R.textures,re=R.isWebGLCubeRenderTarget===!0,ue=Q.length>1;if(ue||(ne.__webglTexture===void 0&&(ne.__webglTexture=i.createTexture()),ne.__version=S.version,o.memory.textures++),re){z.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(S.mipmaps.length>0){z.__webglFramebuffer[Z]=[];for(let K=0;K<S.mipmaps.length;K++)z.__webglFramebuffer[Z][K]=i.createFramebuffer()}else z.__webglFramebuffer[Z]=i.createFramebuffer()}else{if(S.mipmaps.length>0){z.__webglFramebuffer=[];for(let Z=0;Z<S.mipmaps.length;Z++)z.__webglFramebuffer[Z]=i.createFramebuffer()}else z.__webglFramebuffer=i.createFramebuffer();if(ue)for(let Z=0,K=Q.length;Z<K;Z++){let ae=n.get(Q[Z]);ae.__webglTexture===void 0&&(ae.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&pe(R)===!1){z.__webglMultisampledFramebuffer=i.createFramebuffer(),z.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,z.__webglMultisampledFramebuffer);for(let Z=0;Z<Q.length;Z++){let K=Q[Z];z.__webglColorRenderbuffer[Z]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,z.__webglColorRenderbuffer[Z]);let ae=r.convert(K.format,K.colorSpace),N=r.convert(K.type),J=A(K.internalFormat,ae,N,K.normalized,K.colorSpace,R.isXRRenderTarget===!0),$=wt(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,$,J,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Z,i.RENDERBUFFER,z.__webglColorRenderbuffer[Z])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(z.__webglDepthRenderbuffer=i.createRenderbuffer(),yi(z.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(re){t.bindTexture(i.TEXTURE_CUBE_MAP,ne.__webglTexture),lt(i.TEXTURE_CUBE_MAP,S);for(let Z=0;Z<6;Z++)if(S.mipmaps.length>0)for(let K=0;K<S.mipmaps.length;K++)Tt(z.__webglFramebuffer[Z][K],R,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,K);else Tt(z.__webglFramebuffer[Z],R,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);v(S)?M(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ue){for(let Z=0,K=Q.length;Z<K;Z++){let ae=Q[Z],N=n.get(ae),J=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(J=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(J,N.__webglTexture),lt(J,ae),Tt(z.__webglFramebuffer,R,ae,i.COLOR_ATTACHMENT0+Z,J,0),v(ae)&&M(J)}t.unbindTexture()}else{let Z=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(Z=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(Z,ne.__webglTexture),lt(Z,S),S.mipmaps.length>0)for(let K=0;K<S.mipmaps.length;K++)Tt(z.__webglFramebuffer[K],R,S,i.COLOR_ATTACHMENT0,Z,K);else Tt(z.__webglFramebuffer,R,S,i.COLOR_ATTACHMENT0,Z,0);v(S)?M(Z):S.mipmaps.length>0&&i.texParameteri(Z,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&qn(R)}function F(R){let S=R.textures;for(let z=0,ne=S.length;z<ne;z++){let Q=S[z];if(v(Q)&&Q.mipmapsAutoUpdate===!0){let re=w(R),ue=n.get(Q).__webglTexture;t.bindTexture(re,ue),M(re),t.unbindTexture()}}}let Yn=[];function St(R){if(R.samples>0){if(pe(R)===!1){let S=R.textures,z=R.width,ne=R.height,Q=i.COLOR_BUFFER_BIT,re=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ue=n.get(R),Z=S.length>1;if(Z)for(let ae=0;ae<S.length;ae++)t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ae,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ae,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ue.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ue.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ue.__webglFramebuffer);for(let ae=0;ae<S.length;ae++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(Q|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(Q|=i.STENCIL_BUFFER_BIT)),Z){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ue.__webglColorRenderbuffer[ae]);let N=n.get(S[ae]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,N,0)}i.blitFramebuffer(0,0,z,ne,0,0,z,ne,Q,i.NEAREST),l===!0&&(Yn.length=0,Yn.push(i.COLOR_ATTACHMENT0+ae),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Yn.push(re),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Yn))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Z)for(let ae=0;ae<S.length;ae++){t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ae,i.RENDERBUFFER,ue.__webglColorRenderbuffer[ae]);let N=n.get(S[ae]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ae,i.TEXTURE_2D,N,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ue.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let S=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function wt(R){return Math.min(s.maxSamples,R.samples)}function pe(R){let S=n.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Ut(R){let S=o.render.frame;u.get(R)!==S&&(u.set(R,S),R.update())}function Ne(R,S){let z=R.colorSpace,ne=R.format,Q=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||z!==Bo&&z!==ji&&(Ke.getTransfer(z)===rt?(ne!==di||Q!==In)&&Ie("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ue("WebGLTextures: Unsupported texture color space:",z)),S}function Be(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=Pe,this.resetTextureUnits=j,this.getTextureUnits=te,this.setTextureUnits=ve,this.setTexture2D=ge,this.setTexture2DArray=Me,this.setTexture3D=Le,this.setTextureCube=ye,this.rebindTextures=Xn,this.setupRenderTarget=$n,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=St,this.setupDepthRenderbuffer=qn,this.setupFrameBufferTexture=Tt,this.useMultisampledRTT=pe,this.dispose=B}function Kw(i,e){function t(n,s=ji){let r,o=Ke.getTransfer(s);if(n===In)return i.UNSIGNED_BYTE;if(n===xc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===yc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Sd)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===wd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Md)return i.BYTE;if(n===bd)return i.SHORT;if(n===Yr)return i.UNSIGNED_SHORT;if(n===gc)return i.INT;if(n===ui)return i.UNSIGNED_INT;if(n===ei)return i.FLOAT;if(n===hi)return i.HALF_FLOAT;if(n===Ad)return i.ALPHA;if(n===Ed)return i.RGB;if(n===di)return i.RGBA;if(n===qi)return i.DEPTH_COMPONENT;if(n===Zi)return i.DEPTH_STENCIL;if(n===_c)return i.RED;if(n===vc)return i.RED_INTEGER;if(n===Ss)return i.RG;if(n===Mc)return i.RG_INTEGER;if(n===bc)return i.RGBA_INTEGER;if(n===ma||n===ga||n===xa||n===ya)if(o===rt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===ma)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ga)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===ma)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ga)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===xa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ya)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Sc||n===wc||n===Ac||n===Ec)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Sc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===wc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Ac)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Ec)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Tc||n===Rc||n===Cc||n===Ic||n===Pc||n===_a||n===Lc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Tc||n===Rc)return o===rt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Cc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Ic)return r.COMPRESSED_R11_EAC;if(n===Pc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===_a)return r.COMPRESSED_RG11_EAC;if(n===Lc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Nc||n===Dc||n===Uc||n===Fc||n===Oc||n===Bc||n===kc||n===zc||n===Gc||n===Vc||n===Hc||n===Wc||n===qc||n===Xc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Nc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Dc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Uc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Fc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Oc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Bc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===kc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===zc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Gc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Vc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Hc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Wc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===qc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Xc)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===$c||n===Yc||n===Zc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===$c)return o===rt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Yc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Zc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===jc||n===Kc||n===va||n===Jc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===jc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Kc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===va)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Jc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===ir?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var Jw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Qw=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Yd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Jo(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Qn({vertexShader:Jw,fragmentShader:Qw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new $e(new Qs(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Zd=class extends Mi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,g=typeof XRWebGLBinding<"u",m=new Yd,x={},y=t.getContextAttributes(),v=null,M=null,w=[],A=[],_=new Ge,b=null,I=null,T=new xn;T.viewport=new at;let L=new xn;L.viewport=new at;let D=[T,L],O=new dc,P=null,B=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Y){let ge=w[Y];return ge===void 0&&(ge=new Br,w[Y]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(Y){let ge=w[Y];return ge===void 0&&(ge=new Br,w[Y]=ge),ge.getGripSpace()},this.getHand=function(Y){let ge=w[Y];return ge===void 0&&(ge=new Br,w[Y]=ge),ge.getHandSpace()};function H(Y){let ge=A.indexOf(Y.inputSource);if(ge===-1)return;let Me=w[ge];Me!==void 0&&(Me.update(Y.inputSource,Y.frame,c||o),Me.dispatchEvent({type:Y.type,data:Y.inputSource}))}function V(){s.removeEventListener("select",H),s.removeEventListener("selectstart",H),s.removeEventListener("selectend",H),s.removeEventListener("squeeze",H),s.removeEventListener("squeezestart",H),s.removeEventListener("squeezeend",H),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",ee);for(let Y=0;Y<w.length;Y++){let ge=A[Y];ge!==null&&(A[Y]=null,w[Y].disconnect(ge))}P=null,B=null,m.reset();for(let Y in x)delete x[Y];if(e.setRenderTarget(v),f=null,d=null,h=null,s=null,M=null,Pe.stop(),n.isPresenting=!1,e.setPixelRatio(b),e.setSize(_.width,_.height,!1),I!==null){let Y=I.camera;Y.fov=I.fov,Y.zoom=I.zoom,Y.updateProjectionMatrix(),I=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Y){r=Y,n.isPresenting===!0&&Ie("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Y){a=Y,n.isPresenting===!0&&Ie("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Y){c=Y},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&g&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Y){if(s=Y,s!==null){if(v=e.getRenderTarget(),s.addEventListener("select",H),s.addEventListener("selectstart",H),s.addEventListener("selectend",H),s.addEventListener("squeeze",H),s.addEventListener("squeezestart",H),s.addEventListener("squeezeend",H),s.addEventListener("end",V),s.addEventListener("inputsourceschange",ee),y.xrCompatible!==!0&&await t.makeXRCompatible(),b=e.getPixelRatio(),e.getSize(_),g&&"createProjectionLayer"in XRWebGLBinding.prototype){let Me=null,Le=null,ye=null;y.depth&&(ye=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Me=y.stencil?Zi:qi,Le=y.stencil?ir:ui);let ze={colorFormat:t.RGBA8,depthFormat:ye,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(ze),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),M=new Fn(d.textureWidth,d.textureHeight,{format:di,type:In,depthTexture:new Xi(d.textureWidth,d.textureHeight,Le,void 0,void 0,void 0,void 0,void 0,void 0,Me),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let Me={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,Me),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),M=new Fn(f.framebufferWidth,f.framebufferHeight,{format:di,type:In,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Pe.setContext(s),Pe.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ee(Y){for(let ge=0;ge<Y.removed.length;ge++){let Me=Y.removed[ge],Le=A.indexOf(Me);Le>=0&&(A[Le]=null,w[Le].disconnect(Me))}for(let ge=0;ge<Y.added.length;ge++){let Me=Y.added[ge],Le=A.indexOf(Me);if(Le===-1){for(let ze=0;ze<w.length;ze++)if(ze>=A.length){A.push(Me),Le=ze;break}else if(A[ze]===null){A[ze]=Me,Le=ze;break}if(Le===-1)break}let ye=w[Le];ye&&ye.connect(Me)}}function X(Y,ge){ge===null?Y.matrixWorld.copy(Y.matrix):Y.matrixWorld.multiplyMatrices(ge.matrixWorld,Y.matrix),Y.matrixWorldInverse.copy(Y.matrixWorld).invert()}this.updateCamera=function(Y){if(s===null)return;let ge=Y.near,Me=Y.far;m.texture!==null&&(m.depthNear>0&&(ge=m.depthNear),m.depthFar>0&&(Me=m.depthFar)),O.near=L.near=T.near=ge,O.far=L.far=T.far=Me,(P!==O.near||B!==O.far)&&(s.updateRenderState({depthNear:O.near,depthFar:O.far}),P=O.near,B=O.far),O.layers.mask=Y.layers.mask|6,T.layers.mask=O.layers.mask&-5,L.layers.mask=O.layers.mask&-3;let Le=Y.parent,ye=O.cameras;X(O,Le);for(let ze=0;ze<ye.length;ze++)X(ye[ze],Le);O.projectionMatrix.copy(T.projectionMatrix),O.projectionMatrixInverse.copy(T.projectionMatrixInverse),I===null&&Y.isPerspectiveCamera&&(I={camera:Y,fov:Y.fov,zoom:Y.zoom}),j(Y,O,Le)};function j(Y,ge,Me){Me===null?Y.matrix.copy(ge.matrixWorld):(Y.matrix.copy(Me.matrixWorld),Y.matrix.invert(),Y.matrix.multiply(ge.matrixWorld)),Y.matrix.decompose(Y.position,Y.quaternion,Y.scale),Y.updateMatrixWorld(!0),Y.projectionMatrix.copy(ge.projectionMatrix),Y.projectionMatrixInverse.copy(ge.projectionMatrixInverse),Y.isPerspectiveCamera&&(Y.fov=Fr*2*Math.atan(1/Y.projectionMatrix.elements[5]),Y.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Y){l=Y,d!==null&&(d.fixedFoveation=Y),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Y)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(O)},this.getCameraTexture=function(Y){return x[Y]};let te=null;function ve(Y,ge){if(u=ge.getViewerPose(c||o),p=ge,u!==null){let Me=u.views;f!==null&&(e.setRenderTargetFramebuffer(M,f.framebuffer),e.setRenderTarget(M));let Le=!1;Me.length!==O.cameras.length&&(O.cameras.length=0,Le=!0);for(let De=0;De<Me.length;De++){let lt=Me[De],ft=null;if(f!==null)ft=f.getViewport(lt);else{let Jt=h.getViewSubImage(d,lt);ft=Jt.viewport,De===0&&(e.setRenderTargetTextures(M,Jt.colorTexture,Jt.depthStencilTexture),e.setRenderTarget(M))}let Ye=D[De];Ye===void 0&&(Ye=new xn,Ye.layers.enable(De),Ye.viewport=new at,D[De]=Ye),Ye.matrix.fromArray(lt.transform.matrix),Ye.matrix.decompose(Ye.position,Ye.quaternion,Ye.scale),Ye.projectionMatrix.fromArray(lt.projectionMatrix),Ye.projectionMatrixInverse.copy(Ye.projectionMatrix).invert(),Ye.viewport.set(ft.x,ft.y,ft.width,ft.height),De===0&&(O.matrix.copy(Ye.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),Le===!0&&O.cameras.push(Ye)}let ye=s.enabledFeatures;if(ye&&ye.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&g){h=n.getBinding();let De=h.getDepthInformation(Me[0]);De&&De.isValid&&De.texture&&m.init(De,s.renderState)}if(ye&&ye.includes("camera-access")&&g){e.state.unbindTexture(),h=n.getBinding();for(let De=0;De<Me.length;De++){let lt=Me[De].camera;if(lt){let ft=x[lt];ft||(ft=new Jo,x[lt]=ft);let Ye=h.getCameraImage(lt);ft.sourceTexture=Ye}}}}for(let Me=0;Me<w.length;Me++){let Le=A[Me],ye=w[Me];Le!==null&&ye!==void 0&&ye.update(Le,ge,c||o)}te&&te(Y,ge),ge.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ge}),p=null}let Pe=new Eg;Pe.setAnimationLoop(ve),this.setAnimationLoop=function(Y){te=Y},this.dispose=function(){}}},eA=new Qe,Fg=new Oe;Fg.set(-1,0,0,0,1,0,0,0,1);function tA(i,e){function t(m,x){m.matrixAutoUpdate===!0&&m.updateMatrix(),x.value.copy(m.matrix)}function n(m,x){x.color.getRGB(m.fogColor.value,Fd(i)),x.isFog?(m.fogNear.value=x.near,m.fogFar.value=x.far):x.isFogExp2&&(m.fogDensity.value=x.density)}function s(m,x,y,v,M){x.isNodeMaterial?x.uniformsNeedUpdate=!1:x.isMeshBasicMaterial?r(m,x):x.isMeshLambertMaterial?(r(m,x),x.envMap&&(m.envMapIntensity.value=x.envMapIntensity)):x.isMeshToonMaterial?(r(m,x),h(m,x)):x.isMeshPhongMaterial?(r(m,x),u(m,x),x.envMap&&(m.envMapIntensity.value=x.envMapIntensity)):x.isMeshStandardMaterial?(r(m,x),d(m,x),x.isMeshPhysicalMaterial&&f(m,x,M)):x.isMeshMatcapMaterial?(r(m,x),p(m,x)):x.isMeshDepthMaterial?r(m,x):x.isMeshDistanceMaterial?(r(m,x),g(m,x)):x.isMeshNormalMaterial?r(m,x):x.isLineBasicMaterial?(o(m,x),x.isLineDashedMaterial&&a(m,x)):x.isPointsMaterial?l(m,x,y,v):x.isSpriteMaterial?c(m,x):x.isShadowMaterial?(m.color.value.copy(x.color),m.opacity.value=x.opacity):x.isShaderMaterial&&(x.uniformsNeedUpdate=!1)}function r(m,x){m.opacity.value=x.opacity,x.color&&m.diffuse.value.copy(x.color),x.emissive&&m.emissive.value.copy(x.emissive).multiplyScalar(x.emissiveIntensity),x.map&&(m.map.value=x.map,t(x.map,m.mapTransform)),x.alphaMap&&(m.alphaMap.value=x.alphaMap,t(x.alphaMap,m.alphaMapTransform)),x.bumpMap&&(m.bumpMap.value=x.bumpMap,t(x.bumpMap,m.bumpMapTransform),m.bumpScale.value=x.bumpScale,x.side===vn&&(m.bumpScale.value*=-1)),x.normalMap&&(m.normalMap.value=x.normalMap,t(x.normalMap,m.normalMapTransform),m.normalScale.value.copy(x.normalScale),x.side===vn&&m.normalScale.value.negate()),x.displacementMap&&(m.displacementMap.value=x.displacementMap,t(x.displacementMap,m.displacementMapTransform),m.displacementScale.value=x.displacementScale,m.displacementBias.value=x.displacementBias),x.emissiveMap&&(m.emissiveMap.value=x.emissiveMap,t(x.emissiveMap,m.emissiveMapTransform)),x.specularMap&&(m.specularMap.value=x.specularMap,t(x.specularMap,m.specularMapTransform)),x.alphaTest>0&&(m.alphaTest.value=x.alphaTest);let y=e.get(x),v=y.envMap,M=y.envMapRotation;v&&(m.envMap.value=v,m.envMapRotation.value.setFromMatrix4(eA.makeRotationFromEuler(M)).transpose(),v.isCubeTexture&&v.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Fg),m.reflectivity.value=x.reflectivity,m.ior.value=x.ior,m.refractionRatio.value=x.refractionRatio),x.lightMap&&(m.lightMap.value=x.lightMap,m.lightMapIntensity.value=x.lightMapIntensity,t(x.lightMap,m.lightMapTransform)),x.aoMap&&(m.aoMap.value=x.aoMap,m.aoMapIntensity.value=x.aoMapIntensity,t(x.aoMap,m.aoMapTransform))}function o(m,x){m.diffuse.value.copy(x.color),m.opacity.value=x.opacity,x.map&&(m.map.value=x.map,t(x.map,m.mapTransform))}function a(m,x){m.dashSize.value=x.dashSize,m.totalSize.value=x.dashSize+x.gapSize,m.scale.value=x.scale}function l(m,x,y,v){m.diffuse.value.copy(x.color),m.opacity.value=x.opacity,m.size.value=x.size*y,m.scale.value=v*.5,x.map&&(m.map.value=x.map,t(x.map,m.uvTransform)),x.alphaMap&&(m.alphaMap.value=x.alphaMap,t(x.alphaMap,m.alphaMapTransform)),x.alphaTest>0&&(m.alphaTest.value=x.alphaTest)}function c(m,x){m.diffuse.value.copy(x.color),m.opacity.value=x.opacity,m.rotation.value=x.rotation,x.map&&(m.map.value=x.map,t(x.map,m.mapTransform)),x.alphaMap&&(m.alphaMap.value=x.alphaMap,t(x.alphaMap,m.alphaMapTransform)),x.alphaTest>0&&(m.alphaTest.value=x.alphaTest)}function u(m,x){m.specular.value.copy(x.specular),m.shininess.value=Math.max(x.shininess,1e-4)}function h(m,x){x.gradientMap&&(m.gradientMap.value=x.gradientMap)}function d(m,x){m.metalness.value=x.metalness,x.metalnessMap&&(m.metalnessMap.value=x.metalnessMap,t(x.metalnessMap,m.metalnessMapTransform)),m.roughness.value=x.roughness,x.roughnessMap&&(m.roughnessMap.value=x.roughnessMap,t(x.roughnessMap,m.roughnessMapTransform)),x.envMap&&(m.envMapIntensity.value=x.envMapIntensity)}function f(m,x,y){m.ior.value=x.ior,x.diffuseRoughness>0&&(m.diffuseRoughness.value=x.diffuseRoughness,x.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=x.diffuseRoughnessMap,t(x.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),x.sheen>0&&(m.sheenColor.value.copy(x.sheenColor).multiplyScalar(x.sheen),m.sheenRoughness.value=x.sheenRoughness,x.sheenColorMap&&(m.sheenColorMap.value=x.sheenColorMap,t(x.sheenColorMap,m.sheenColorMapTransform)),x.sheenRoughnessMap&&(m.sheenRoughnessMap.value=x.sheenRoughnessMap,t(x.sheenRoughnessMap,m.sheenRoughnessMapTransform))),x.clearcoat>0&&(m.clearcoat.value=x.clearcoat,m.clearcoatRoughness.value=x.clearcoatRoughness,x.clearcoatMap&&(m.clearcoatMap.value=x.clearcoatMap,t(x.clearcoatMap,m.clearcoatMapTransform)),x.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=x.clearcoatRoughnessMap,t(x.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),x.clearcoatNormalMap&&(m.clearcoatNormalMap.value=x.clearcoatNormalMap,t(x.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(x.clearcoatNormalScale),x.side===vn&&m.clearcoatNormalScale.value.negate())),x.dispersion>0&&(m.dispersion.value=x.dispersion),x.retroreflectivity>0&&(m.retroreflectivity.value=x.retroreflectivity),x.iridescence>0&&(m.iridescence.value=x.iridescence,m.iridescenceIOR.value=x.iridescenceIOR,m.iridescenceThicknessMinimum.value=x.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=x.iridescenceThicknessMaximum,x.iridescenceMap&&(m.iridescenceMap.value=x.iridescenceMap,t(x.iridescenceMap,m.iridescenceMapTransform)),x.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=x.iridescenceThicknessMap,t(x.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),x.transmission>0&&(m.transmission.value=x.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),x.transmissionMap&&(m.transmissionMap.value=x.transmissionMap,t(x.transmissionMap,m.transmissionMapTransform)),m.thickness.value=x.thickness,x.thicknessMap&&(m.thicknessMap.value=x.thicknessMap,t(x.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=x.attenuationDistance,m.attenuationColor.value.copy(x.attenuationColor)),x.anisotropy>0&&(m.anisotropyVector.value.set(x.anisotropy*Math.cos(x.anisotropyRotation),x.anisotropy*Math.sin(x.anisotropyRotation)),x.anisotropyMap&&(m.anisotropyMap.value=x.anisotropyMap,t(x.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=x.specularIntensity,m.specularColor.value.copy(x.specularColor),x.specularColorMap&&(m.specularColorMap.value=x.specularColorMap,t(x.specularColorMap,m.specularColorMapTransform)),x.specularIntensityMap&&(m.specularIntensityMap.value=x.specularIntensityMap,t(x.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,x){x.matcap&&(m.matcap.value=x.matcap)}function g(m,x){let y=e.get(x).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function nA(i,e,t,n){let s={},r={};function o(y,v){let M=v.program;n.uniformBlockBinding(y,M,s[y.id])}function a(y,v){let M=s[y.id];M===void 0&&(p(y),M=l(y),s[y.id]=M,y.addEventListener("dispose",m));let w=v.program;n.updateUBOMapping(y,w);let A=e.render.frame;r[y.id]!==A&&(c(y),r[y.id]=A)}function l(y){let v=i.createBuffer(),M=y.__size,w=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,v),i.bufferData(i.UNIFORM_BUFFER,M,w),i.bindBuffer(i.UNIFORM_BUFFER,null),v}function c(y){let v=s[y.id],M=y.uniforms,w=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,v);for(let A=0,_=M.length;A<_;A++){let b=M[A];if(Array.isArray(b))for(let I=0,T=b.length;I<T;I++)u(b[I],A,I,w);else u(b,A,0,w)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(y,v,M,w){if(d(y,v,M,w)===!0){let A=y.__offset,_=y.value;if(Array.isArray(_)){let b=0;for(let I=0;I<_.length;I++){let T=_[I],L=g(T,!0);h(T,y.__data,b),b+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else h(_,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,A,y.__data)}}function h(y,v,M){typeof y=="number"||typeof y=="boolean"?v[M]=y:y.isMatrix3?(v[M]=y.elements[0],v[M+1]=y.elements[1],v[M+2]=y.elements[2],v[M+3]=0,v[M+4]=y.elements[3],v[M+5]=y.elements[4],v[M+6]=y.elements[5],v[M+7]=0,v[M+8]=y.elements[6],v[M+9]=y.elements[7],v[M+10]=y.elements[8],v[M+11]=0):ArrayBuffer.isView(y)?v.set(y.subarray(0,v.length-M),M):y.toArray(v,M)}function d(y,v,M,w){let A=y.value,_=v+"_"+M;if(Array.isArray(A)){w[_]===void 0&&(w[_]=[]);let b=w[_],I=!1;for(let T=0;T<A.length;T++)f(A[T],b,T)===!0&&(I=!0);return I}return f(A,w,_)}function f(y,v,M){if(v[M]===void 0)return typeof y=="number"||typeof y=="boolean"?v[M]=y:ArrayBuffer.isView(y)?v[M]=y.slice():v[M]=y.clone(),!0;{let w=v[M];if(typeof y=="number"||typeof y=="boolean"){if(w!==y)return v[M]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(w.equals(y)===!1)return w.copy(y),!0}}return!1}function p(y){let v=y.uniforms,M=0,w=16;for(let _=0,b=v.length;_<b;_++){let I=Array.isArray(v[_])?v[_]:[v[_]];for(let T=0,L=I.length;T<L;T++){let D=I[T],O=Array.isArray(D.value)?D.value:[D.value],P=Array.isArray(v[_])||Array.isArray(D.value),B=M;for(let V=0,ee=O.length;V<ee;V++){let X=O[V],j=g(X,P),te=M%w,ve=te%j.boundary,Pe=te+ve;M+=ve,Pe!==0&&w-Pe<j.storage&&(M+=w-Pe),V===0&&(B=M),M+=j.storage}let H=D.type==="int"?Int32Array:D.type==="uint"?Uint32Array:Float32Array;D.__data=new H((M-B)/Float32Array.BYTES_PER_ELEMENT),D.__offset=B}}let A=M%w;return A>0&&(M+=w-A),y.__size=M,y.__cache={},this}function g(y,v){let M={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(M.boundary=4,M.storage=4):y.isVector2?(M.boundary=8,M.storage=8):y.isVector3||y.isColor?(M.boundary=16,M.storage=12):y.isVector4?(M.boundary=16,M.storage=16):y.isMatrix3?(M.boundary=16,M.storage=48):y.isMatrix4?(M.boundary=16,M.storage=64):y.isTexture?Ie("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(M.boundary=16,M.storage=y.byteLength):Ie("WebGLRenderer: Unsupported uniform value type.",y),v===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function m(y){let v=y.target;v.removeEventListener("dispose",m),i.deleteBuffer(s[v.id]),delete s[v.id],delete r[v.id]}function x(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:x}}var iA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ai=null;function sA(){return Ai===null&&(Ai=new li(iA,16,16,Ss,hi),Ai.name="DFG_LUT",Ai.minFilter=Ft,Ai.magFilter=Ft,Ai.wrapS=vi,Ai.wrapT=vi,Ai.generateMipmaps=!1,Ai.needsUpdate=!0),Ai}var su=class{constructor(e={}){let{canvas:t=Jm(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=In}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let g=f,m=new Set([bc,Mc,vc]),x=new Set([In,ui,Yr,ir,xc,yc]),y=new Uint32Array(4),v=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},w=null,A=null,_=[],b=[],I=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=wi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let T=this,L=!1,D=null,O=null,P=null,B=null;this._outputColorSpace=Un;let H=0,V=0,ee=null,X=-1,j=null,te=new at,ve=new at,Pe=null,Y=new Fe(0),ge=0,Me=t.width,Le=t.height,ye=1,ze=null,Pt=null,De=new at(0,0,Me,Le),lt=new at(0,0,Me,Le),ft=!1,Ye=new ms,Jt=new Yl,Dt=!1,En=!1,Tt=new Qe,yi=new C,Gt=new at,qn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Xn=!1;function $n(){return ee===null?ye:1}let F=n;function Yn(E,U){return t.getContext(E,U)}let St,wt,pe,Ut,Ne,Be,R,S,z,ne,Q,re,ue,Z,K,ae,N,J,$,le,se,oe,Re;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ce,!1),t.addEventListener("webglcontextrestored",We,!1),t.addEventListener("webglcontextcreationerror",xe,!1),F===null){let U="webgl2";if(F=Yn(U,E),F===null)throw Yn(U)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}qe()}catch(E){throw t.removeEventListener("webglcontextlost",Ce,!1),t.removeEventListener("webglcontextrestored",We,!1),t.removeEventListener("webglcontextcreationerror",xe,!1),Ue("WebGLRenderer: "+E.message),E}function qe(){St=new m1(F),St.init(),se=new Kw(F,St),wt=new s1(F,St,e,se),pe=new Zw(F,St),wt.reversedDepthBuffer&&d&&pe.buffers.depth.setReversed(!0),O=F.createFramebuffer(),P=F.createFramebuffer(),B=F.createFramebuffer(),Ut=new y1(F),Ne=new Uw,Be=new jw(F,St,pe,Ne,wt,se,Ut),R=new p1(T),S=new vM(F),oe=new n1(F,S),z=new g1(F,S,Ut,oe),ne=new v1(F,z,S,oe,Ut),J=new _1(F,wt,Be),K=new r1(Ne),Q=new Dw(T,R,St,wt,oe,K),re=new tA(T,Ne),ue=new Ow,Z=new Hw(St),N=new t1(T,R,pe,ne,p,l),ae=new Yw(T,ne,wt),Re=new nA(F,Ut,wt,pe),$=new i1(F,St,Ut),le=new x1(F,St,Ut),Ut.programs=Q.programs,T.capabilities=wt,T.extensions=St,T.properties=Ne,T.renderLists=ue,T.shadowMap=ae,T.state=pe,T.info=Ut}g!==In&&(I=new b1(g,t.width,t.height,a,s,r));let ie=new Zd(T,F);this.xr=ie,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let E=St.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=St.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return ye},this.setPixelRatio=function(E){E!==void 0&&(ye=E,this.setSize(Me,Le,!1))},this.getSize=function(E){return E.set(Me,Le)},this.setSize=function(E,U,q=!0){if(ie.isPresenting){Ie("WebGLRenderer: Can't change size while VR device is presenting.");return}Me=E,Le=U,t.width=Math.floor(E*ye),t.height=Math.floor(U*ye),q===!0&&(t.style.width=E+"px",t.style.height=U+"px"),I!==null&&I.setSize(t.width,t.height),this.setViewport(0,0,E,U)},this.getDrawingBufferSize=function(E){return E.set(Me*ye,Le*ye).floor()},this.setDrawingBufferSize=function(E,U,q){Me=E,Le=U,ye=q,t.width=Math.floor(E*q),t.height=Math.floor(U*q),this.setViewport(0,0,E,U)},this.setEffects=function(E){if(g===In){Ue("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let U=0;U<E.length;U++)if(E[U].isOutputPass===!0){Ie("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(te)},this.getViewport=function(E){return E.copy(De)},this.setViewport=function(E,U,q,k){E.isVector4?De.set(E.x,E.y,E.z,E.w):De.set(E,U,q,k),pe.viewport(te.copy(De).multiplyScalar($n()).round())},this.getScissor=function(E){return E.copy(lt)},this.setScissor=function(E,U,q,k){E.isVector4?lt.set(E.x,E.y,E.z,E.w):lt.set(E,U,q,k),pe.scissor(ve.copy(lt).multiplyScalar($n()).round())},this.getScissorTest=function(){return ft},this.setScissorTest=function(E){pe.setScissorTest(ft=E)},this.setOpaqueSort=function(E){ze=E},this.setTransparentSort=function(E){Pt=E},this.getClearColor=function(E){return E.copy(N.getClearColor())},this.setClearColor=function(){N.setClearColor(...arguments)},this.getClearAlpha=function(){return N.getClearAlpha()},this.setClearAlpha=function(){N.setClearAlpha(...arguments)},this.clear=function(E=!0,U=!0,q=!0){let k=0;if(E){let G=!1;if(ee!==null){let he=ee.texture.format;G=m.has(he)}if(G){let he=ee.texture.type,be=x.has(he),ce=N.getClearColor(),_e=N.getClearAlpha(),Ee=ce.r,ke=ce.g,Ze=ce.b;be?(y[0]=Ee,y[1]=ke,y[2]=Ze,y[3]=_e,F.clearBufferuiv(F.COLOR,0,y)):(v[0]=Ee,v[1]=ke,v[2]=Ze,v[3]=_e,F.clearBufferiv(F.COLOR,0,v))}else k|=F.COLOR_BUFFER_BIT}U&&(k|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),q&&(k|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k!==0&&F.clear(k)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),D=E},this.dispose=function(){t.removeEventListener("webglcontextlost",Ce,!1),t.removeEventListener("webglcontextrestored",We,!1),t.removeEventListener("webglcontextcreationerror",xe,!1),N.dispose(),ue.dispose(),Z.dispose(),Be.dispose(),Ne.dispose(),R.dispose(),ne.dispose(),z.dispose(),oe.dispose(),Re.dispose(),Q.dispose(),ie.dispose(),ie.removeEventListener("sessionstart",Tp),ie.removeEventListener("sessionend",Rp),qs.stop()};function Ce(E){E.preventDefault(),Go("WebGLRenderer: Context Lost."),L=!0}function We(){Go("WebGLRenderer: Context Restored."),L=!1;let E=Ut.autoReset,U=ae.enabled,q=ae.autoUpdate,k=ae.needsUpdate,G=ae.type;qe(),Ut.autoReset=E,ae.enabled=U,ae.autoUpdate=q,ae.needsUpdate=k,ae.type=G}function xe(E){Ue("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function ct(E){let U=E.target;U.removeEventListener("dispose",ct),Vt(U)}function Vt(E){as(E),Ne.remove(E)}function as(E){let U=Ne.get(E).programs;U!==void 0&&(U.forEach(function(q){Q.releaseProgram(q)}),E.isShaderMaterial&&Q.releaseShaderCache(E))}this.renderBufferDirect=function(E,U,q,k,G,he){U===null&&(U=qn);let be=G.isMesh&&G.matrixWorld.determinantAffine()<0,ce=hv(E,U,q,k,G);pe.setMaterial(k,be);let _e=q.index,Ee=1;if(k.wireframe===!0){if(_e=z.getWireframeAttribute(q),_e===void 0)return;Ee=2}let ke=q.drawRange,Ze=q.attributes.position,Se=ke.start*Ee,je=(ke.start+ke.count)*Ee;he!==null&&(Se=Math.max(Se,he.start*Ee),je=Math.min(je,(he.start+he.count)*Ee)),_e!==null?(Se=Math.max(Se,0),je=Math.min(je,_e.count)):Ze!=null&&(Se=Math.max(Se,0),je=Math.min(je,Ze.count));let Lt=je-Se;if(Lt<0||Lt===1/0)return;oe.setup(G,k,ce,q,_e);let gt,pt=$;if(_e!==null&&(gt=S.get(_e),pt=le,pt.setIndex(gt)),G.isMesh)k.wireframe===!0?(pe.setLineWidth(k.wireframeLinewidth*$n()),pt.setMode(F.LINES)):pt.setMode(F.TRIANGLES);else if(G.isLine){let ln=k.linewidth;ln===void 0&&(ln=1),pe.setLineWidth(ln*$n()),G.isLineSegments?pt.setMode(F.LINES):G.isLineLoop?pt.setMode(F.LINE_LOOP):pt.setMode(F.LINE_STRIP)}else G.isPoints?pt.setMode(F.POINTS):G.isSprite&&pt.setMode(F.TRIANGLES);if(G.isBatchedMesh)if(St.get("WEBGL_multi_draw"))pt.renderMultiDraw(G._multiDrawStarts,G._multiDrawCounts,G._multiDrawCount);else{let ln=G._multiDrawStarts,we=G._multiDrawCounts,mn=G._multiDrawCount,st=_e?S.get(_e).bytesPerElement:1,Xs=Ne.get(k).currentProgram.getUniforms();for(let cn=0;cn<mn;cn++)Xs.setValue(F,"_gl_DrawID",cn),pt.render(ln[cn]/st,we[cn])}else if(G.isInstancedMesh)pt.renderInstances(Se,Lt,G.count);else if(q.isInstancedBufferGeometry){let ln=q._maxInstanceCount!==void 0?q._maxInstanceCount:1/0,we=Math.min(q.instanceCount,ln);pt.renderInstances(Se,Lt,we)}else pt.render(Se,Lt)};function Ep(E,U,q,k){D!==null&&E.isNodeMaterial&&D.setObject(k,E),Dt===!0&&K.setState(E,q,!1),E.transparent===!0&&E.side===Si&&E.forceSinglePass===!1?(E.side=vn,E.needsUpdate=!0,To(E,U,k),E.side=bs,E.needsUpdate=!0,To(E,U,k),E.side=Si):To(E,U,k)}this.compile=function(E,U,q=null){q===null&&(q=E),D!==null&&D.renderStart(E,U,q),A=Z.get(q),A.init(U),b.push(A),q.traverseVisible(function(G){G.isLight&&G.layers.test(U.layers)&&(A.pushLight(G),G.castShadow&&A.pushShadow(G))}),E!==q&&E.traverseVisible(function(G){G.isLight&&G.layers.test(U.layers)&&(A.pushLight(G),G.castShadow&&A.pushShadow(G))}),A.setupLights(),D!==null&&D.updateLights(A.state.lightsArray),En=this.localClippingEnabled,Dt=K.init(this.clippingPlanes,En),Dt===!0&&K.setGlobalState(this.clippingPlanes,U),D!==null&&ae.render(A.state.shadowsArray,q,U);let k=new Set;return E.traverse(function(G){if(!(G.isMesh||G.isPoints||G.isLine||G.isSprite))return;let he=G.material;if(he)if(Array.isArray(he))for(let be=0;be<he.length;be++){let ce=he[be];Ep(ce,q,U,G),k.add(ce)}else Ep(he,q,U,G),k.add(he)}),A=b.pop(),D!==null&&D.renderEnd(),k},this.compileAsync=function(E,U,q=null){let k=this.compile(E,U,q);return new Promise(G=>{function he(){if(k.forEach(function(be){let _e=Ne.get(be).currentProgram;(_e===void 0||_e.isReady())&&k.delete(be)}),k.size===0){G(E);return}setTimeout(he,10)}St.get("KHR_parallel_shader_compile")!==null?he():setTimeout(he,10)})};let Eh=null;function cv(E){Eh&&Eh(E)}function Tp(){qs.stop()}function Rp(){qs.start()}let qs=new Eg;qs.setAnimationLoop(cv),typeof self<"u"&&qs.setContext(self),this.setAnimationLoop=function(E){Eh=E,ie.setAnimationLoop(E),E===null?qs.stop():qs.start()},ie.addEventListener("sessionstart",Tp),ie.addEventListener("sessionend",Rp),this.render=function(E,U){if(U!==void 0&&U.isCamera!==!0){Ue("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;D!==null&&D.renderStart(E,U);let q=ie.enabled===!0&&ie.isPresenting===!0,k=I!==null&&(ee===null||q)&&I.begin(T,ee);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),U.parent===null&&U.matrixWorldAutoUpdate===!0&&U.updateMatrixWorld(),ie.enabled===!0&&ie.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(ie.cameraAutoUpdate===!0&&ie.updateCamera(U),U=ie.getCamera()),E.isScene===!0&&E.onBeforeRender(T,E,U,ee),A=Z.get(E,b.length),A.init(U),A.state.textureUnits=Be.getTextureUnits(),b.push(A),Tt.multiplyMatrices(U.projectionMatrix,U.matrixWorldInverse),U.isArrayCamera?Jt.setFromArrayCamera(U):Ye.setFromProjectionMatrix(Tt,jn,U.reversedDepth),En=this.localClippingEnabled,Dt=K.init(this.clippingPlanes,En),w=ue.get(E,_.length),w.init(),_.push(w),this.info.render.frame++,ie.enabled===!0&&ie.isPresenting===!0){let be=T.xr.getDepthSensingMesh();be!==null&&Th(be,U,-1/0,T.sortObjects)}Th(E,U,0,T.sortObjects),w.finish(),D!==null&&D.updateLights(A.state.lightsArray),T.sortObjects===!0&&w.sort(ze,Pt),Xn=ie.enabled===!1||ie.isPresenting===!1||ie.hasDepthSensing()===!1,Xn&&N.addToRenderList(w,E),this.info.autoReset===!0&&this.info.reset(),Dt===!0&&K.beginShadows();let G=A.state.shadowsArray;if(ae.render(G,E,U),Dt===!0&&K.endShadows(),(k&&I.hasRenderPass())===!1){let be=w.opaque,ce=w.transmissive;if(A.setupLights(),U.isArrayCamera){let _e=U.cameras;if(ce.length>0)for(let Ee=0,ke=_e.length;Ee<ke;Ee++){let Ze=_e[Ee];Ip(be,ce,E,Ze)}Xn&&N.render(E);for(let Ee=0,ke=_e.length;Ee<ke;Ee++){let Ze=_e[Ee];Cp(w,E,Ze,Ze.viewport)}}else ce.length>0&&Ip(be,ce,E,U),Xn&&N.render(E),Cp(w,E,U)}ee!==null&&V===0&&(Be.updateMultisampleRenderTarget(ee),Be.updateRenderTargetMipmap(ee)),k&&I.end(T),E.isScene===!0&&E.onAfterRender(T,E,U),oe.resetDefaultState(),X=-1,j=null,b.pop(),b.length>0?(A=b[b.length-1],Be.setTextureUnits(A.state.textureUnits),Dt===!0&&K.setGlobalState(T.clippingPlanes,A.state.camera)):A=null,_.pop(),_.length>0?w=_[_.length-1]:w=null,D!==null&&D.renderEnd()};function Th(E,U,q,k){if(E.visible===!1)return;if(E.layers.test(U.layers)){if(E.isGroup)q=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(U);else if(E.isLight)A.pushLight(E),E.castShadow&&A.pushShadow(E);else if(E.isSprite){let be=U.isArrayCamera?Jt:Ye;if(!E.frustumCulled||E.intersectsFrustum(be)){k&&Gt.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Tt);let ce=ne.update(E),_e=E.material;_e.visible&&w.push(E,ce,_e,q,Gt.z,null,U)}}else if(E.isMesh||E.isLine||E.isPoints){let be=U.isArrayCamera?Jt:Ye;if(!E.frustumCulled||E.intersectsFrustum(be)){let ce=ne.update(E),_e=E.material;if(k&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Gt.copy(E.boundingSphere.center)):(ce.boundingSphere===null&&ce.computeBoundingSphere(),Gt.copy(ce.boundingSphere.center)),Gt.applyMatrix4(E.matrixWorld).applyMatrix4(Tt)),Array.isArray(_e)){let Ee=ce.groups;for(let ke=0,Ze=Ee.length;ke<Ze;ke++){let Se=Ee[ke],je=_e[Se.materialIndex];je&&je.visible&&w.push(E,ce,je,q,Gt.z,Se,U)}}else _e.visible&&w.push(E,ce,_e,q,Gt.z,null,U)}}}let he=E.children;for(let be=0,ce=he.length;be<ce;be++)Th(he[be],U,q,k)}function Cp(E,U,q,k){let{opaque:G,transmissive:he,transparent:be}=E;A.setupLightsView(q),Dt===!0&&K.setGlobalState(T.clippingPlanes,q),k&&pe.viewport(te.copy(k)),G.length>0&&Qa(G,U,q),he.length>0&&Qa(he,U,q),be.length>0&&Qa(be,U,q),pe.buffers.depth.setTest(!0),pe.buffers.depth.setMask(!0),pe.buffers.color.setMask(!0),pe.setPolygonOffset(!1)}function Ip(E,U,q,k){if((q.isScene===!0?q.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[k.id]===void 0){let Se=St.has("EXT_color_buffer_half_float")||St.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[k.id]=new Fn(1,1,{generateMipmaps:!0,type:Se?hi:In,minFilter:Yi,samples:Math.max(4,wt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ke.workingColorSpace})}let he=A.state.transmissionRenderTarget[k.id],be=k.viewport||te;he.setSize(be.z*T.transmissionResolutionScale,be.w*T.transmissionResolutionScale);let ce=T.getRenderTarget(),_e=T.getActiveCubeFace(),Ee=T.getActiveMipmapLevel();T.setRenderTarget(he),T.getClearColor(Y),ge=T.getClearAlpha(),ge<1&&T.setClearColor(16777215,.5),T.clear(),Xn&&N.render(q);let ke=T.toneMapping;T.toneMapping=wi;let Ze=k.viewport;if(k.viewport!==void 0&&(k.viewport=void 0),A.setupLightsView(k),Dt===!0&&K.setGlobalState(T.clippingPlanes,k),Qa(E,q,k),Be.updateMultisampleRenderTarget(he),Be.updateRenderTargetMipmap(he),St.has("WEBGL_multisampled_render_to_texture")===!1){let Se=!1;for(let je=0,Lt=U.length;je<Lt;je++){let gt=U[je],{object:pt,geometry:ln,material:we,group:mn}=gt;if(we.side===Si&&pt.layers.test(k.layers)){let st=we.side;we.side=vn,we.needsUpdate=!0,Pp(pt,q,k,ln,we,mn),we.side=st,we.needsUpdate=!0,Se=!0}}Se===!0&&(Be.updateMultisampleRenderTarget(he),Be.updateRenderTargetMipmap(he))}T.setRenderTarget(ce,_e,Ee),T.setClearColor(Y,ge),Ze!==void 0&&(k.viewport=Ze),T.toneMapping=ke}function Qa(E,U,q){let k=U.isScene===!0?U.overrideMaterial:null;for(let G=0,he=E.length;G<he;G++){let be=E[G],{object:ce,geometry:_e,group:Ee}=be,ke=be.material;ke.allowOverride===!0&&k!==null&&(ke=k),ce.layers.test(q.layers)&&Pp(ce,U,q,_e,ke,Ee)}}function Pp(E,U,q,k,G,he){D!==null&&G.isNodeMaterial&&D.setObject(E,G),E.onBeforeRender(T,U,q,k,G,he),E.modelViewMatrix.multiplyMatrices(q.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),G.onBeforeRender(T,U,q,k,E,he),G.transparent===!0&&G.side===Si&&G.forceSinglePass===!1?(G.side=vn,G.needsUpdate=!0,T.renderBufferDirect(q,U,k,G,E,he),G.side=bs,G.needsUpdate=!0,T.renderBufferDirect(q,U,k,G,E,he),G.side=Si):T.renderBufferDirect(q,U,k,G,E,he),E.onAfterRender(T,U,q,k,G,he)}function Lp(E){let U=0;for(let q of E)q.texture!==null&&U++;return U}function To(E,U,q){U.isScene!==!0&&(U=qn);let k=Ne.get(E),G=A.state.lights,he=A.state.shadowsArray,be=G.state.version,ce=Q.getParameters(E,G.state,he,U,q,A.state.lightProbeGridArray),_e=Q.getProgramCacheKey(ce),Ee=k.programs;k.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?U.environment:null,k.fog=U.fog;let ke=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;k.envMap=R.get(E.envMap||k.environment,ke),k.envMapRotation=k.environment!==null&&E.envMap===null?U.environmentRotation:E.envMapRotation,Ee===void 0&&(E.addEventListener("dispose",ct),Ee=new Map,k.programs=Ee,k.programVariants=new Map);let Ze=Ee.get(_e);if(Ze!==void 0){if(k.currentProgram===Ze&&k.lightsStateVersion===be)return Dp(E,ce),Ze}else ce.uniforms=Q.getUniforms(E),D!==null&&E.isNodeMaterial&&D.build(E,q,ce),E.onBeforeCompile(ce,T),Ze=Q.acquireProgram(ce,_e),Ee.set(_e,Ze),k.uniforms=ce.uniforms;let Se=k.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Se.clippingPlanes=K.uniform),Dp(E,ce),k.needsLights=fv(E),k.lightsStateVersion=be,k.needsLights&&(Se.ambientLightColor.value=G.state.ambient,Se.lightProbe.value=G.state.probe,Se.sunLights.value=G.state.sun,Se.sunLightShadows.value=G.state.sunShadow,Se.directionalLights.value=G.state.directional,Se.directionalLightShadows.value=G.state.directionalShadow,Se.spotLights.value=G.state.spot,Se.spotLightShadows.value=G.state.spotShadow,Se.rectAreaLights.value=G.state.rectArea,Se.ltc_1.value=G.state.rectAreaLTC1,Se.ltc_2.value=G.state.rectAreaLTC2,Se.pointLights.value=G.state.point,Se.pointLightShadows.value=G.state.pointShadow,Se.hemisphereLights.value=G.state.hemi,Se.sunShadowMatrix.value=G.state.sunShadowMatrix,Se.sunShadowCascade.value=G.state.sunShadowCascade,Se.directionalShadowMatrix.value=G.state.directionalShadowMatrix,Se.spotLightMatrix.value=G.state.spotLightMatrix,Se.spotLightMap.value=G.state.spotLightMap,Se.pointShadowMatrix.value=G.state.pointShadowMatrix),k.numLightProbeGrids=Lp(A.state.lightProbeGridArray),k.currentProgram=Ze,k.uniformsList=null,Ze}function uv(E,U,q,k,G){let he=Ne.get(E),be=he.currentProgram.id+","+k+","+G,ce=he.programVariants.get(be);return ce===void 0?(ce=To(E,U,q),he.programVariants.set(be,ce)):(he.currentProgram=ce,he.uniformsList=null,he.outputColorSpace=k,he.toneMapping=G),ce}function Np(E){if(E.uniformsList===null){let U=E.currentProgram.getUniforms();E.uniformsList=jr.seqWithValue(U.seq,E.uniforms)}return E.uniformsList}function Dp(E,U){let q=Ne.get(E);q.outputColorSpace=U.outputColorSpace,q.batching=U.batching,q.batchingColor=U.batchingColor,q.instancing=U.instancing,q.instancingColor=U.instancingColor,q.instancingMorph=U.instancingMorph,q.skinning=U.skinning,q.morphTargets=U.morphTargets,q.morphNormals=U.morphNormals,q.morphColors=U.morphColors,q.morphTargetsCount=U.morphTargetsCount,q.numClippingPlanes=U.numClippingPlanes,q.numIntersection=U.numClipIntersection,q.vertexAlphas=U.vertexAlphas,q.vertexTangents=U.vertexTangents,q.toneMapping=U.toneMapping}function hv(E,U,q,k,G){U.isScene!==!0&&(U=qn),Be.resetTextureUnits();let he=U.fog,be=k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial?U.environment:null,ce=ee===null?T.outputColorSpace:ee.isXRRenderTarget===!0?ee.texture.colorSpace:Ke.workingColorSpace,_e=k.isMeshStandardMaterial||k.isMeshLambertMaterial&&!k.envMap||k.isMeshPhongMaterial&&!k.envMap,Ee=R.get(k.envMap||be,_e),ke=k.vertexColors===!0&&!!q.attributes.color&&q.attributes.color.itemSize===4,Ze=!!q.attributes.tangent&&(!!k.normalMap||k.anisotropy>0),Se=!!q.morphAttributes.position,je=!!q.morphAttributes.normal,Lt=!!q.morphAttributes.color,gt=wi;k.toneMapped&&(ee===null||ee.isXRRenderTarget===!0)&&(gt=T.toneMapping);let pt=q.morphAttributes.position||q.morphAttributes.normal||q.morphAttributes.color,ln=pt!==void 0?pt.length:0,we=Ne.get(k),mn=A.state.lights;if(Dt===!0&&(En===!0||E!==j)){let Rt=E===j&&k.id===X;K.setState(k,E,Rt)}let st=!1,Xs=!1;k.version===we.__version?we.needsLights&&we.lightsStateVersion!==mn.state.version||G.isBatchedMesh&&we.batching===!1||!G.isBatchedMesh&&we.batching===!0||G.isBatchedMesh&&we.batchingColor===!0&&G._colorsTexture===null||G.isBatchedMesh&&we.batchingColor===!1&&G._colorsTexture!==null||G.isInstancedMesh&&we.instancing===!1||!G.isInstancedMesh&&we.instancing===!0||G.isSkinnedMesh&&we.skinning===!1||!G.isSkinnedMesh&&we.skinning===!0||G.isInstancedMesh&&we.instancingColor===!0&&G.instanceColor===null||G.isInstancedMesh&&we.instancingColor===!1&&G.instanceColor!==null||G.isInstancedMesh&&we.instancingMorph===!0&&G.morphTexture===null||G.isInstancedMesh&&we.instancingMorph===!1&&G.morphTexture!==null||we.envMap!==Ee||k.fog===!0&&we.fog!==he||we.numClippingPlanes!==void 0&&(we.numClippingPlanes!==K.numPlanes||we.numIntersection!==K.numIntersection)||we.vertexAlphas!==ke||we.vertexTangents!==Ze||we.morphTargets!==Se||we.morphNormals!==je||we.morphColors!==Lt||we.morphTargetsCount!==ln||we.numLightProbeGrids!==Lp(A.state.lightProbeGridArray)?st=!0:(we.outputColorSpace!==ce||we.toneMapping!==gt)&&(Xs=!0):(st=!0,we.__version=k.version);let cn=we.currentProgram;(st===!0||Xs===!0)&&(cn=Xs===!0?uv(k,U,G,ce,gt):To(k,U,G),D&&k.isNodeMaterial&&D.onUpdateProgram(k,cn,we));let el=!1,ls=!1,$s=!1,nt=cn.getUniforms(),Qt=we.uniforms;if(pe.useProgram(cn.program)&&(el=!0,ls=!0,$s=!0),k.id!==X&&(X=k.id,ls=!0),el||j!==E){pe.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),nt.setValue(F,"projectionMatrix",E.projectionMatrix),nt.setValue(F,"viewMatrix",E.matrixWorldInverse);let Ht=nt.map.cameraPosition;Ht!==void 0&&Ht.setValue(F,yi.setFromMatrixPosition(E.matrixWorld)),wt.logarithmicDepthBuffer&&nt.setValue(F,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(k.isMeshPhongMaterial||k.isMeshToonMaterial||k.isMeshLambertMaterial||k.isMeshBasicMaterial||k.isMeshStandardMaterial||k.isShaderMaterial)&&nt.setValue(F,"isOrthographic",E.isOrthographicCamera===!0),j!==E&&(j=E,ls=!0,$s=!0)}if(we.needsLights&&(mn.state.sunShadowMap.length>0&&nt.setValue(F,"sunShadowMap",mn.state.sunShadowMap,Be),mn.state.directionalShadowMap.length>0&&nt.setValue(F,"directionalShadowMap",mn.state.directionalShadowMap,Be),mn.state.spotShadowMap.length>0&&nt.setValue(F,"spotShadowMap",mn.state.spotShadowMap,Be),mn.state.pointShadowMap.length>0&&nt.setValue(F,"pointShadowMap",mn.state.pointShadowMap,Be)),G.isSkinnedMesh){nt.setOptional(F,G,"bindMatrix"),nt.setOptional(F,G,"bindMatrixInverse");let Rt=G.skeleton;Rt&&(Rt.boneTexture===null&&Rt.computeBoneTexture(),nt.setValue(F,"boneTexture",Rt.boneTexture,Be))}G.isBatchedMesh&&(nt.setOptional(F,G,"batchingTexture"),nt.setValue(F,"batchingTexture",G._matricesTexture,Be),nt.setOptional(F,G,"batchingIdTexture"),nt.setValue(F,"batchingIdTexture",G._indirectTexture,Be),nt.setOptional(F,G,"batchingColorTexture"),G._colorsTexture!==null&&nt.setValue(F,"batchingColorTexture",G._colorsTexture,Be));let ii=q.morphAttributes;if((ii.position!==void 0||ii.normal!==void 0||ii.color!==void 0)&&J.update(G,q,cn),(ls||we.receiveShadow!==G.receiveShadow)&&(we.receiveShadow=G.receiveShadow,nt.setValue(F,"receiveShadow",G.receiveShadow)),(k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial)&&k.envMap===null&&U.environment!==null&&(Qt.envMapIntensity.value=U.environmentIntensity),Qt.dfgLUT!==void 0&&(Qt.dfgLUT.value=sA()),ls){if(nt.setValue(F,"toneMappingExposure",T.toneMappingExposure),we.needsLights&&dv(Qt,$s),he&&k.fog===!0&&re.refreshFogUniforms(Qt,he),re.refreshMaterialUniforms(Qt,k,ye,Le,A.state.transmissionRenderTarget[E.id]),we.needsLights&&we.numLightProbeGrids>0){let Rt=M,Ht=0;for(let Oi of A.state.lightProbeGridArray)Oi.texture!==null&&(Rt.textures[Ht]=Oi.texture,Rt.min[Ht]=Oi.boundingBox.min,Rt.max[Ht]=Oi.boundingBox.max,Rt.resolution[Ht]=Oi.resolution,Ht++);for(let Oi in Rt)Rt[Oi].length=Ht;Qt.probesSH.value=Rt.textures,Qt.probesMin.value=Rt.min,Qt.probesMax.value=Rt.max,Qt.probesResolution.value=Rt.resolution}jr.upload(F,Np(we),Qt,Be)}if(k.isShaderMaterial&&k.uniformsNeedUpdate===!0&&(jr.upload(F,Np(we),Qt,Be),k.uniformsNeedUpdate=!1),k.isSpriteMaterial&&nt.setValue(F,"center",G.center),nt.setValue(F,"modelViewMatrix",G.modelViewMatrix),nt.setValue(F,"normalMatrix",G.normalMatrix),nt.setValue(F,"modelMatrix",G.matrixWorld),k.uniformsGroups!==void 0){let Rt=k.uniformsGroups;for(let Ht=0,Oi=Rt.length;Ht<Oi;Ht++){let Fp=Rt[Ht];Re.update(Fp,cn),Re.bind(Fp,cn)}}return cn}function dv(E,U){E.ambientLightColor.needsUpdate=U,E.lightProbe.needsUpdate=U,E.sunLights.needsUpdate=U,E.sunLightShadows.needsUpdate=U,E.directionalLights.needsUpdate=U,E.directionalLightShadows.needsUpdate=U,E.pointLights.needsUpdate=U,E.pointLightShadows.needsUpdate=U,E.spotLights.needsUpdate=U,E.spotLightShadows.needsUpdate=U,E.rectAreaLights.needsUpdate=U,E.hemisphereLights.needsUpdate=U}function fv(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return H},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ee},this.setRenderTargetTextures=function(E,U,q){let k=Ne.get(E);k.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,k.__autoAllocateDepthBuffer===!1&&(k.__useRenderToTexture=!1),Ne.get(E.texture).__webglTexture=U,Ne.get(E.depthTexture).__webglTexture=k.__autoAllocateDepthBuffer?void 0:q,k.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,U){let q=Ne.get(E);q.__webglFramebuffer=U,q.__useDefaultFramebuffer=U===void 0},this.setRenderTarget=function(E,U=0,q=0){ee=E,H=U,V=q;let k=null,G=!1,he=!1;if(E){let ce=Ne.get(E);if(ce.__useDefaultFramebuffer!==void 0){pe.bindFramebuffer(F.FRAMEBUFFER,ce.__webglFramebuffer),te.copy(E.viewport),ve.copy(E.scissor),Pe=E.scissorTest,pe.viewport(te),pe.scissor(ve),pe.setScissorTest(Pe),X=-1;return}else if(ce.__webglFramebuffer===void 0)Be.setupRenderTarget(E);else if(ce.__hasExternalTextures)Be.rebindTextures(E,Ne.get(E.texture).__webglTexture,Ne.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let ke=E.depthTexture;if(ce.__boundDepthTexture!==ke){if(ke!==null&&Ne.has(ke)&&(E.width!==ke.image.width||E.height!==ke.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Be.setupDepthRenderbuffer(E)}}let _e=E.texture;(_e.isData3DTexture||_e.isDataArrayTexture||_e.isCompressedArrayTexture)&&(he=!0);let Ee=Ne.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Ee[U])?k=Ee[U][q]:k=Ee[U],G=!0):E.samples>0&&Be.useMultisampledRTT(E)===!1?k=Ne.get(E).__webglMultisampledFramebuffer:Array.isArray(Ee)?k=Ee[q]:k=Ee,te.copy(E.viewport),ve.copy(E.scissor),Pe=E.scissorTest}else te.copy(De).multiplyScalar(ye).floor(),ve.copy(lt).multiplyScalar(ye).floor(),Pe=ft;if(q!==0&&(k=O),pe.bindFramebuffer(F.FRAMEBUFFER,k)&&pe.drawBuffers(E,k),pe.viewport(te),pe.scissor(ve),pe.setScissorTest(Pe),G){let ce=Ne.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+U,ce.__webglTexture,q)}else if(he){let ce=U;for(let _e=0;_e<E.textures.length;_e++){let Ee=Ne.get(E.textures[_e]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+_e,Ee.__webglTexture,q,ce)}}else if(E!==null&&q!==0){let ce=Ne.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ce.__webglTexture,q)}X=-1};function Up(E){let U=Ne.get(E);return(U.__readFormat!==E.format||U.__readType!==E.type)&&(U.__readFormat=E.format,U.__readType=E.type,U.__formatReadable=wt.textureFormatReadable(E.format),U.__typeReadable=wt.textureTypeReadable(E.type)),U}this.readRenderTargetPixels=function(E,U,q,k,G,he,be,ce=0){if(!(E&&E.isWebGLRenderTarget)){Ue("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let _e=Ne.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&be!==void 0&&(_e=_e[be],Array.isArray(_e)&&(_e=_e[0])),_e){pe.bindFramebuffer(F.FRAMEBUFFER,_e);try{let Ee=E.textures[ce],ke=Ee.format,Ze=Ee.type;E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+ce);let Se=Up(Ee);if(Se.__formatReadable===!1){Ue("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Se.__typeReadable===!1){Ue("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}U>=0&&U<=E.width-k&&q>=0&&q<=E.height-G&&F.readPixels(U,q,k,G,se.convert(ke),se.convert(Ze),he)}finally{let Ee=ee!==null?Ne.get(ee).__webglFramebuffer:null;pe.bindFramebuffer(F.FRAMEBUFFER,Ee)}}},this.readRenderTargetPixelsAsync=async function(E,U,q,k,G,he,be,ce=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let _e=Ne.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&be!==void 0&&(_e=_e[be],Array.isArray(_e)&&(_e=_e[0])),_e)if(U>=0&&U<=E.width-k&&q>=0&&q<=E.height-G){pe.bindFramebuffer(F.FRAMEBUFFER,_e);let Ee=E.textures[ce],ke=Ee.format,Ze=Ee.type;E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+ce);let Se=Up(Ee);if(Se.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Se.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let je=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,je),F.bufferData(F.PIXEL_PACK_BUFFER,he.byteLength,F.STREAM_READ),F.readPixels(U,q,k,G,se.convert(ke),se.convert(Ze),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let Lt=ee!==null?Ne.get(ee).__webglFramebuffer:null;pe.bindFramebuffer(F.FRAMEBUFFER,Lt);let gt=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await eg(F,gt,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,je),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,he),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(je),F.deleteSync(gt),he}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,U=null,q=0){let k=Math.pow(2,-q),G=Math.floor(E.image.width*k),he=Math.floor(E.image.height*k),be=U!==null?U.x:0,ce=U!==null?U.y:0;Be.setTexture2D(E,0),F.copyTexSubImage2D(F.TEXTURE_2D,q,0,0,be,ce,G,he),pe.unbindTexture()},this.copyTextureToTexture=function(E,U,q=null,k=null,G=0,he=0){let be,ce,_e,Ee,ke,Ze,Se,je,Lt,gt=E.isCompressedTexture?E.mipmaps[he]:E.image;if(q!==null)be=q.max.x-q.min.x,ce=q.max.y-q.min.y,_e=q.isBox3?q.max.z-q.min.z:1,Ee=q.min.x,ke=q.min.y,Ze=q.isBox3?q.min.z:0;else{let nt=Math.pow(2,-G);be=Math.floor(gt.width*nt),ce=Math.floor(gt.height*nt),E.isDataArrayTexture?_e=gt.depth:E.isData3DTexture?_e=Math.floor(gt.depth*nt):_e=1,Ee=0,ke=0,Ze=0}k!==null?(Se=k.x,je=k.y,Lt=k.z):(Se=0,je=0,Lt=0);let pt=se.convert(U.format),ln=se.convert(U.type),we;U.isData3DTexture?(Be.setTexture3D(U,0),we=F.TEXTURE_3D):U.isDataArrayTexture||U.isCompressedArrayTexture?(Be.setTexture2DArray(U,0),we=F.TEXTURE_2D_ARRAY):(Be.setTexture2D(U,0),we=F.TEXTURE_2D),pe.activeTexture(F.TEXTURE0),pe.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,U.flipY),pe.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,U.premultiplyAlpha),pe.pixelStorei(F.UNPACK_ALIGNMENT,U.unpackAlignment);let mn=pe.getParameter(F.UNPACK_ROW_LENGTH),st=pe.getParameter(F.UNPACK_IMAGE_HEIGHT),Xs=pe.getParameter(F.UNPACK_SKIP_PIXELS),cn=pe.getParameter(F.UNPACK_SKIP_ROWS),el=pe.getParameter(F.UNPACK_SKIP_IMAGES);pe.pixelStorei(F.UNPACK_ROW_LENGTH,gt.width),pe.pixelStorei(F.UNPACK_IMAGE_HEIGHT,gt.height),pe.pixelStorei(F.UNPACK_SKIP_PIXELS,Ee),pe.pixelStorei(F.UNPACK_SKIP_ROWS,ke),pe.pixelStorei(F.UNPACK_SKIP_IMAGES,Ze);let ls=E.isDataArrayTexture||E.isData3DTexture,$s=U.isDataArrayTexture||U.isData3DTexture;if(E.isDepthTexture){let nt=Ne.get(E),Qt=Ne.get(U),ii=Ne.get(nt.__renderTarget),Rt=Ne.get(Qt.__renderTarget);pe.bindFramebuffer(F.READ_FRAMEBUFFER,ii.__webglFramebuffer),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,Rt.__webglFramebuffer);for(let Ht=0;Ht<_e;Ht++)ls&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ne.get(E).__webglTexture,G,Ze+Ht),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ne.get(U).__webglTexture,he,Lt+Ht)),F.blitFramebuffer(Ee,ke,Ee+be,ke+ce,Se,je,Se+be,je+ce,F.DEPTH_BUFFER_BIT,F.NEAREST);pe.bindFramebuffer(F.READ_FRAMEBUFFER,null),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(G!==0||E.isRenderTargetTexture||Ne.has(E)){let nt=Ne.get(E),Qt=Ne.get(U);pe.bindFramebuffer(F.READ_FRAMEBUFFER,P),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,B);for(let ii=0;ii<_e;ii++)ls?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,nt.__webglTexture,G,Ze+ii):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,nt.__webglTexture,G),$s?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Qt.__webglTexture,he,Lt+ii):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Qt.__webglTexture,he),G!==0?F.blitFramebuffer(Ee,ke,Ee+be,ke+ce,Se,je,Se+be,je+ce,F.COLOR_BUFFER_BIT,F.NEAREST):$s?F.copyTexSubImage3D(we,he,Se,je,Lt+ii,Ee,ke,be,ce):F.copyTexSubImage2D(we,he,Se,je,Ee,ke,be,ce);pe.bindFramebuffer(F.READ_FRAMEBUFFER,null),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else $s?E.isDataTexture||E.isData3DTexture?F.texSubImage3D(we,he,Se,je,Lt,be,ce,_e,pt,ln,gt.data):U.isCompressedArrayTexture?F.compressedTexSubImage3D(we,he,Se,je,Lt,be,ce,_e,pt,gt.data):F.texSubImage3D(we,he,Se,je,Lt,be,ce,_e,pt,ln,gt):E.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,he,Se,je,be,ce,pt,ln,gt.data):E.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,he,Se,je,gt.width,gt.height,pt,gt.data):F.texSubImage2D(F.TEXTURE_2D,he,Se,je,be,ce,pt,ln,gt);pe.pixelStorei(F.UNPACK_ROW_LENGTH,mn),pe.pixelStorei(F.UNPACK_IMAGE_HEIGHT,st),pe.pixelStorei(F.UNPACK_SKIP_PIXELS,Xs),pe.pixelStorei(F.UNPACK_SKIP_ROWS,cn),pe.pixelStorei(F.UNPACK_SKIP_IMAGES,el),he===0&&U.generateMipmaps===!0&&U.mipmapsAutoUpdate===!0&&F.generateMipmap(we),pe.unbindTexture()},this.initRenderTarget=function(E){Ne.get(E).__webglFramebuffer===void 0&&Be.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Be.setTextureCube(E,0):E.isData3DTexture?Be.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Be.setTexture2DArray(E,0):Be.setTexture2D(E,0),pe.unbindTexture()},this.resetState=function(){H=0,V=0,ee=null,pe.reset(),oe.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return jn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Ke._getDrawingBufferColorSpace(e),t.unpackColorSpace=Ke._getUnpackColorSpace()}};var cu=26,au=.1,Og=1.55,[rA,oA]=[.4,6],aA=5,lu=class{constructor(e){this.azimuth=.52,this.elevation=.38,this.zoom=1,this.onChange=e,this.taken=null,document.addEventListener("pointerdown",t=>t.target!==this.taken&&this.letGo(),{capture:!0}),document.addEventListener("keydown",t=>t.key==="Escape"&&this.letGo())}take(e){this.letGo(),this.taken=e,e.parentElement.classList.add("held")}letGo(){this.taken?.parentElement?.classList.remove("held"),this.taken=null}turn(e,t){this.azimuth-=e,this.elevation=Math.min(Og,Math.max(-Og,this.elevation+t)),this.onChange()}closer(e){this.zoom=Math.min(oA,Math.max(rA,this.zoom*e)),this.onChange()}place(e,t,n,s){let r=cu*Math.PI/360,o=Math.min(r,Math.atan(Math.tan(r)*s)),a=n/Math.sin(o)/this.zoom,[l,c]=[Math.cos(this.elevation),Math.sin(this.elevation)];e.position.set(l*Math.cos(this.azimuth),l*Math.sin(this.azimuth),c).multiplyScalar(a).add(t),e.up.set(0,0,1),e.aspect=s,e.near=Math.max(a-4*n,a/100),e.far=a+8*n,e.lookAt(t),e.updateProjectionMatrix(),e.updateMatrixWorld()}listen(e){let t=new Map,n=null,s=()=>{let[r,o]=[...t.values()];return Math.hypot(r[0]-o[0],r[1]-o[1])};e.addEventListener("pointerdown",r=>{r.button===0&&(n=[r.clientX,r.clientY],t.set(r.pointerId,n),e.setPointerCapture(r.pointerId))}),e.addEventListener("mousedown",r=>r.preventDefault()),e.addEventListener("pointermove",r=>{let o=t.get(r.pointerId);if(!o)return;let a=t.size===2?s():0;t.set(r.pointerId,[r.clientX,r.clientY]),t.size===2?this.closer(s()/Math.max(a,1)):t.size===1&&this.turn((r.clientX-o[0])*.008,(r.clientY-o[1])*.008)});for(let r of["pointerup","pointercancel"])e.addEventListener(r,o=>t.delete(o.pointerId));e.addEventListener("pointerup",r=>{n&&Math.hypot(r.clientX-n[0],r.clientY-n[1])<aA&&r.pointerType==="mouse"&&this.take(e),n=null}),e.addEventListener("wheel",r=>this.wheel(r,e),{passive:!1})}wheel(e,t){this.taken!==t&&!e.ctrlKey||(e.preventDefault(),this.closer(Math.exp(-.002*(e.deltaY||e.deltaX))))}key(e){let t={ArrowLeft:[au,0],ArrowRight:[-au,0],ArrowUp:[0,au],ArrowDown:[0,-au]};if(t[e])this.turn(...t[e]);else if(e==="PageUp")this.closer(1.15);else if(e==="PageDown")this.closer(1/1.15);else return!1;return!0}},Bg=()=>new xn(cu,1,.1,100),jd=new C(0,0,0);var Pn={language:"en",mark:".",languages:[],table:{}},kg=({languages:i,table:e})=>Object.assign(Pn,{languages:i,table:e}),lA=i=>globalThis.polhodeWords?.[i],rr=()=>[...new Set(["en",...Pn.languages,...Object.keys(globalThis.polhodeWords??{})])];function zg(i){return i.map(t=>String(t).toLowerCase().split("-")[0]).find(t=>rr().includes(t))??"en"}function Gg(i){let e=new Intl.NumberFormat(i).formatToParts(1.5).find(({type:t})=>t==="decimal").value;Object.assign(Pn,{language:i,mark:e})}var uu=()=>Pn.language;function W(i,e=null){if(Array.isArray(i))return W(...i);let t=cA(i,Pn.language)??i;return e?t.replace(/\{(\w+)\}/g,(n,s)=>Object.hasOwn(e,s)?uA(e[s]):n):t}function cA(i,e){let t=lA(e);if(t&&Object.hasOwn(t,i))return t[i];if(Object.hasOwn(Pn.table,i))return Pn.table[i][Pn.languages.indexOf(e)]||void 0}var uA=i=>typeof i=="number"?Xt(String(i)):i,Xt=i=>Pn.mark==="."?i:i.replace(/(\d)\.(?=\d)/g,`$1${Pn.mark}`),Jr=i=>i.map(Xt).join(Pn.mark===","?"; ":", ");function Vg(i){let{language:e,mark:t}=Pn;Object.assign(Pn,{language:"en",mark:"."});try{return i()}finally{Object.assign(Pn,{language:e,mark:t})}}var Hg=new Map,As=({key:i,usual:e=!0})=>Hg.get(i)??e,Wg=(i,e)=>Hg.set(i,e),Qr=(i,e,t,n=!0)=>({key:i,color:e,text:t,usual:n});var hu=i=>document.getElementById(i);function Kd({name:i,title:e=i,summary:t,notes:n}){hu("name").textContent=W(e),hu("summary").textContent=W(t),hu("notes").replaceChildren(...n.map(s=>Es("li",W(s))))}function Es(i,e,t=""){let n=document.createElement(i);return n.textContent=e,t&&(n.className=t),n}function qg(i,e){let t=document.createElement("figure");t.className=i.flat?"panel flat":"panel";let n=document.createElement("canvas");n.setAttribute("role","img"),i.flat||(n.tabIndex=0,e.listen(n),n.addEventListener("keydown",r=>{e.key(r.key)&&r.preventDefault()}));let s=document.createElement("button");return s.type="button",s.className="enlarge",t.append(n,document.createElement("figcaption"),s),hu("panels").append(t),n}function Xg(i,e,t,n=()=>{}){let s=i.nextElementSibling,r=e.title==="The body in space"&&t.up==="L"?"L points up":"",o=Es("span",[e.words,r].filter(Boolean).map(u=>W(u)).join("; "),"words"),a=Es("span","","legend");for(let u of e.legend)a.append(hA(u,n));let l=Es("span","","heading");l.append(Es("strong",W(e.title)),o),s.replaceChildren(l,a),s.nextElementSibling.setAttribute("aria-label",W("Make large: {picture}",{picture:W(e.title)}));let c=e.flat?"":` ${W("Arrow keys turn the view, page up and down bring it closer.")}`;i.setAttribute("aria-label",`${[e.title,e.words].filter(Boolean).map(u=>W(u)).join(": ")}.${c}`),i.parentElement.dataset.held=W("The wheel zooms. Esc lets go.")}function hA(i,e){let t=document.createElement("i");if(i.color&&(t.style.background=i.color),i.press){let s=Es("button",W(i.text));return s.type="button",s.setAttribute("aria-pressed",String(i.pressed())),s.addEventListener("click",()=>{i.press(),s.setAttribute("aria-pressed",String(i.pressed())),e()}),s}let n=document.createElement(i.key?"label":"span");if(i.key){let s=document.createElement("input");Object.assign(s,{type:"checkbox",checked:As(i)}),s.dataset.part=i.key,s.setAttribute("aria-label",W("show {part}",{part:W(i.text)})),s.addEventListener("change",()=>{Wg(i.key,s.checked),e()}),n.append(s)}return n.append(t,W(i.text)),n}function $g(i,e){i.replaceChildren(...e.map(([t,n])=>{let s=document.createElement("div");return s.append(Es("dt",W(t)),Es("dd",Xt(W(n)))),s}))}var du=1e3,fu=class{constructor(e,t,n){this.roots=e,this.onChange=t,this.refuse=n,this.rows=new Map}show(e,t){let n=e.map(({key:s})=>s);if(n.join()!==this.keys){this.keys=n.join();let s=new Map(e.map(a=>[a.key,this.rows.get(a.key)??this.row(a)]));this.rows=s;let r=t.filter(a=>s.has(a)),o=n.filter(a=>!r.includes(a));Yg(this.roots.first,r.map(a=>s.get(a).line)),Yg(this.roots.more,o.map(a=>s.get(a).line)),this.roots.fold.hidden=!o.length}for(let s of e)this.refresh(s)}row(e){let t=document.createElement("div");t.className=e.choices?"control choice":"control";let n=document.createElement("label"),s=`set-${e.key.replaceAll(".","-")}`;n.htmlFor=s,t.append(n);let r={label:n,line:t};if(e.choices){r.choice=document.createElement("select"),r.choice.id=s;for(let[o,a]of e.choices)r.choice.append(new Option(W(a),o));r.choice.addEventListener("change",()=>this.onChange(e.key,Number(r.choice.value))),t.append(r.choice)}else r.slider=document.createElement("input"),Object.assign(r.slider,{type:"range",min:0,max:du,step:"any"}),r.slider.addEventListener("input",()=>this.onChange(e.key,dA(r.control,Number(r.slider.value)/du))),r.slider.addEventListener("change",()=>this.settle()),r.field=document.createElement("input"),Object.assign(r.field,{type:"text",inputMode:"decimal",id:s,autocomplete:"off"}),r.field.addEventListener("change",()=>this.typed(r)),r.unit=document.createElement("span"),t.append(r.field,r.unit,r.slider);return r}refresh(e){let t=this.rows.get(e.key),[n,s]=[W(e.label),W(e.unit??"")];if(t.label.textContent=n,t.choice){t.choice.value=String(e.value);return}let r=t.slider===document.activeElement&&t.slider.matches(":active");t.control=r?{...t.control,value:e.value}:e,t.slider.setAttribute("aria-label",n),r||(t.slider.value=String(du*fA(e,e.value))),t.slider.style.setProperty("--part",`${100*Number(t.slider.value)/du}%`);let o=Jd(e.value/(e.si??1));t.slider.setAttribute("aria-valuetext",`${o} ${s}`),document.activeElement!==t.field&&(t.field.value=o),t.unit.textContent=s,t.field.setAttribute("aria-label",`${n} [${s}]`),t.field.setCustomValidity(""),t.field.removeAttribute("aria-invalid")}settle(){this.onChange(null)}typed(e){let t=Number(e.field.value.trim().replace(",","."))*(e.control.si??1),{low:n,high:s,log:r,unit:o,si:a=1}=e.control,l=!e.field.value.trim()||!Number.isFinite(t)?W("A number is needed."):r&&!(t>0)?W("It must be greater than zero."):"",c=e.control.key.startsWith("body.moments")&&(t<n*.999||t>s*1.001),u=l||(c?W("No body has this moment with the two others: {least} to {most} {unit}.",{least:Jd(n/a),most:Jd(s/a),unit:o}):"");e.field.setCustomValidity(u),u?(e.field.setAttribute("aria-invalid","true"),e.field.reportValidity(),this.refuse(u)):this.onChange(e.control.key,t)}};function Yg(i,e){for(let t of[...i.children])e.includes(t)||t.remove();e.forEach((t,n)=>i.children[n]!==t&&i.insertBefore(t,i.children[n]??null))}function dA({low:i,high:e,log:t,power:n=1},s){return t?i*(e/i)**s:i+(e-i)*s**n}function fA({low:i,high:e,log:t,power:n=1},s){let r=t?Math.log(Math.max(s,Number.MIN_VALUE)/i)/Math.log(e/i):((s-i)/(e-i))**(1/n);return Math.min(1,Math.max(0,Number.isFinite(r)?r:0))}function Jd(i){if(i===0)return"0";let e=Math.abs(i);return Xt(e>=.001&&e<1e6?String(Number(i.toPrecision(7))):i.toExponential(5))}var uf={};cs(uf,{asSpec:()=>VE,changed:()=>zE,controls:()=>kE,event:()=>XE,facts:()=>qE,first:()=>FE,from:()=>BE,keys:()=>OE,make:()=>GE,toml:()=>WE,withSpec:()=>HE});var pA=6.283185307179586,mA=-41.341702240399755,gA=81.60524927607504,xA=-76.70585975306136,yA=42.058693944897634,_A=-15.094642576822984,vA=3.8199525848482803,MA=-.7181223017785001,bA=.10422916220813978,SA=1,wA=-19.739208802178716,AA=64.93939402266828,EA=-85.45681720669371,TA=60.24464137187664,RA=-26.426256783374388,CA=7.903536371318465,IA=-1.7143907110886711,PA=.282005968455791,LA=-.03638284114254564;function Mt(i,e){let t=i*e,n=134217729*i,s=134217729*e,r=n-(n-i),o=s-(s-e),a=i-r,l=e-o;return[t,r*o-t+r*l+a*o+a*l]}function It(i){return i+6755399441055744-6755399441055744}function tn(i){let e=It(4*i),t=i-.25*e,n=t*t,s=t*(pA+n*(mA+n*(gA+n*(xA+n*(yA+n*(_A+n*(vA+n*(MA+n*bA)))))))),r=SA+n*(wA+n*(AA+n*(EA+n*(TA+n*(RA+n*(CA+n*(IA+n*(PA+n*LA)))))))),o=e-4*Math.floor(.25*e),a=o===1||o===3,{0:l,1:c}=a?[r,s]:[s,r];return[o>=2?-l:l,o===1||o===2?-c:c]}function bn(i){let e=134217729*i,t=e-(e-i);return[t,i-t]}function Ki(i,e){let{0:t,1:n,2:s}=i,{0:r,1:o,2:a}=e,l=t*r,c=t*o,u=n*r,h=It(l),d=It(c),f=It(u),p=n*o+s*(r+o)+(t+n)*a,{0:g,1:m}=mt(c-d,u-f),{0:x,1:y}=mt(l-h,g),v=It(x);return[x-v,y+(m+p),h+(d+f)+v]}function mt(i,e){let t=i+e,n=t-i;return[t,i-(t-n)+(e-n)]}function Ts(i){return Mt(i,i)}function Ei(i,e){let t=i+e;return[t,e-(t-i)]}function Ae(i,e){let{0:t,1:n}=mt(i[0],e[0]);return Ei(t,n+(i[1]+e[1]))}function it(i,e){return Ae(i,[-e[0],-e[1]])}function me(i,e){let{0:t,1:n}=Mt(i[0],e[0]);return Ei(t,n+(i[0]*e[1]+i[1]*e[0]))}function kn(i,e){let{0:t,1:n}=Mt(i[0],e);return Ei(t,n+i[1]*e)}function Ln(i){let{0:e,1:t}=Mt(i[0],i[0]);return Ei(e,t+2*i[0]*i[1])}function de(i,e){return[i[0]*e,i[1]*e]}function Te(i,e){let t=i[0]/e[0],{0:n,1:s}=Mt(t,e[0]),r=i[0]-n-s+(i[1]-t*e[1]);return Ei(t,r/e[0])}function Rs(i){let e=Math.sqrt(i[0]),{0:t,1:n}=Mt(e,e);return Ei(e,(i[0]-t-n+i[1])/(e+e))}function $t(i){let e=i[0]===0;return e?[0,0]:Rs(e?[1,0]:i)}var Ti=[3.141592653589793,12246467991473532e-32],eo=[.15915494309189535,-9839338337591243e-33],Zg=[.6931471805599453,23190468138462996e-33];var DA=1e-6,jg=1e27,pu=i=>{let e=String(JSON.stringify(i,(t,n)=>typeof n=="number"&&!Number.isFinite(n)?String(n):n));return e.length>80?`${e.slice(0,77)}...`:e};function At(i,e,t){if(typeof e=="number"&&Number.isFinite(e))return e;throw new RangeError(`\`${i}\` must be a finite number; got ${pu(e)}. Give it in ${t}.`)}function Sn(i,e,t,n){let s=e!=null&&typeof e=="object"?Array.from(e):[];if(s.length===t&&s.every(r=>typeof r=="number"&&Number.isFinite(r)))return s;throw new RangeError(`\`${i}\` must be ${t} finite numbers; got ${pu(e)}. Give them in ${n}.`)}function to(i){let e=Sn("moments",i,3,"kg m\xB2");if(e.every(t=>t>0))return e;throw new RangeError(`\`moments\` must be positive; got ${pu(e)} kg m\xB2. A body with a zero moment (a thin rod) cannot spin about that axis; check values and units.`)}function no(i){let e=Sn("attitude",i,4,"w, x, y, z");if(Math.abs(Math.hypot(...e)-1)<DA)return e;throw new RangeError(`\`attitude\` must be a unit quaternion w, x, y, z; got ${pu(e)}. Divide it by its norm, and check that the scalar comes first.`)}function mu(i,e,t){At("t",i,"seconds");let[n,s]=mt(i,-e);if(Math.abs(n)*t<=jg)return[n,s];throw new RangeError(`\`t\` less the epoch, times the rate of rotation, must be at most ${jg} rad, beyond which a phase has hardly a digit left; got ${i} s. Check times and rates.`)}function gu(i){if(!i.every(Number.isFinite))throw new RangeError("moments, momentum or their ratios leave the range of doubles: choose other units.")}var xu=([i,e,t,n,s,r,o])=>({attitude:[i,e,t,n],momentum:[s,r,o]}),zn=i=>Number.isNaN(i)?null:i;var UA=([i,e,t,n])=>[i,-e,-t,-n],FA=([i,e,t,n])=>Math.sqrt(i*i+e*e+t*t+n*n);function io(i){let e=FA(i);return i.map(t=>t/e)}function Ea([i,e,t,n],[s,r,o]){let a=2*(t*o-n*r),l=2*(n*s-e*o),c=2*(e*r-t*s);return[s+i*a+(t*c-n*l),r+i*l+(n*a-e*c),o+i*c+(e*l-t*a)]}var Cs=(i,e)=>Ea(UA(i),e);var OA=[0,.05260015195876773,.0789002279381516,.1183503419072274,.2816496580927726,.3333333333333333,.25,.3076923076923077,.6512820512820513,.6,.8571428571428571,1],Kg=[[],[[0,.05260015195876773]],[[0,.0197250569845379],[1,.0591751709536137]],[[0,.02958758547680685],[2,.08876275643042054]],[[0,.2413651341592667],[2,-.8845494793282861],[3,.924834003261792]],[[0,.037037037037037035],[3,.17082860872947386],[4,.12546768756682242]],[[0,.037109375],[3,.17025221101954405],[4,.06021653898045596],[5,-.017578125]],[[0,.03709200011850479],[3,.17038392571223998],[4,.10726203044637328],[5,-.015319437748624402],[6,.008273789163814023]],[[0,.6241109587160757],[3,-3.3608926294469414],[4,-.868219346841726],[5,27.59209969944671],[6,20.154067550477894],[7,-43.48988418106996]],[[0,.47766253643826434],[3,-2.4881146199716677],[4,-.590290826836843],[5,21.230051448181193],[6,15.279233632882423],[7,-33.28821096898486],[8,-.020331201708508627]],[[0,-.9371424300859873],[3,5.186372428844064],[4,1.0914373489967295],[5,-8.149787010746927],[6,-18.52006565999696],[7,22.739487099350505],[8,2.4936055526796523],[9,-3.0467644718982196]],[[0,2.273310147516538],[3,-10.53449546673725],[4,-2.0008720582248625],[5,-17.9589318631188],[6,27.94888452941996],[7,-2.8589982771350235],[8,-8.87285693353063],[9,12.360567175794303],[10,.6433927460157636]]],BA=[[0,.054293734116568765],[5,4.450312892752409],[6,1.8915178993145003],[7,-5.801203960010585],[8,.3111643669578199],[9,-.1521609496625161],[10,.20136540080403034],[11,.04471061572777259]],kA=[[0,.01312004499419488],[5,-1.2251564463762044],[6,-.4957589496572502],[7,1.6643771824549864],[8,-.35032884874997366],[9,.3341791187130175],[10,.08192320648511571],[11,-.022355307863886294]],zA=[[0,-.18980075407240762],[5,4.450312892752409],[6,1.8915178993145003],[7,-5.801203960010585],[8,-.4226823213237919],[9,-.1521609496625161],[10,.20136540080403034],[11,.02265179219836082]],GA=.01,yu=class{constructor(e,t){this.rates=e,this.size=t,this.stages=Kg.map(()=>new Float64Array(t)),this.inner=new Float64Array(t)}step(e,t,n,s,r=!1){let{rates:o,size:a,stages:l,inner:c}=this;r||o(e,t,l[0]);for(let u=1;u<l.length;u++)Jg(Kg[u],l,t,n,c,a),o(e+OA[u]*n,c,l[u]);Jg(BA,l,t,n,s,a)}error(e,t,n,s,r){let{size:o,stages:a}=this,[l,c]=[0,0];for(let u=0;u<o;u++){let h=r*(s[u]+Math.max(Math.abs(t[u]),Math.abs(n[u])));l+=(Qd(kA,a,u)/h)**2,c+=(Qd(zA,a,u)/h)**2}return l===0&&c===0?0:Math.abs(e)*l/Math.sqrt((l+GA*c)*o)}};function Qd(i,e,t){let n=0;for(let s=0;s<i.length;s++)n+=i[s][1]*e[i[s][0]][t];return n}function Jg(i,e,t,n,s,r){for(let o=0;o<r;o++)s[o]=t[o]+n*Qd(i,e,o)}var VA=1e-12,HA=2e5,WA=2048,qA=16,[Qg,ef,XA]=[.9,.2,8],e0=-1/8,$A=16*Number.EPSILON,YA=60,Ri=class{constructor({rates:e,start:t,time:n=0,scale:s,tolerance:r=VA,project:o,stops:a={},mostSteps:l=HA}){Object.assign(this,{time:n,tolerance:r,mostSteps:l}),this.scale=Float64Array.from(s),this.project=o??(()=>{}),this.stops=Object.entries(a),this._method=new yu((c,u,h)=>e(n+c,u,h),t.length),this._rates=e,this._begun=null,this._forward=this._chain(1,t),this._backward=this._chain(-1,t)}at(e){let t=e-this.time,n=t<0?this._backward:this._forward,s=this._before(n,Math.abs(t)),r=s.state.slice();return s===n.end||s.elapsed===t||this._step(s,t-s.elapsed,r),r}end(e=!0){let{end:t}=e?this._forward:this._backward;return t&&{time:this.time+t.elapsed,event:t.event}}_chain(e,t){let n=Float64Array.from(t),s={elapsed:0,state:n,step:e*this._firstStep(n),count:0};return{sense:e,kept:[s],spacing:qA,from:s,to:null,end:null}}_before(e,t){let{end:n}=e;if(n&&t>=Math.abs(n.elapsed))return n;let s=ZA(e.kept,t);(t<Math.abs(e.from.elapsed)||s.count>e.from.count)&&([e.from,e.to]=[s,null]);for(let r=0;;r++){if(e.to??=this._advance(e,e.from),Math.abs(e.to.elapsed)>t)return e.from;if(e.to===e.end)return e.end;r>=this.mostSteps&&this._tooFar(e,t),[e.from,e.to]=[e.to,null],jA(e,e.from)}}_advance(e,t){let n=new Float64Array(t.state.length),s=t.step,r=XA;for(;;){(!(Math.abs(s)>$A*Math.abs(t.elapsed))||s===0)&&this._stuck(t),this._step(t,s,n);let o=this._method.error(s,t.state,n,this.scale,this.tolerance);if(o<=1){let a=o===0?r:Math.min(r,Math.max(ef,Qg*o**e0)),l={elapsed:t.elapsed+s,state:n,step:s*a,count:t.count+1};return this._ended(e,t,l)??l}s*=o>1?Math.max(ef,Qg*o**e0):ef,r=1}}_step(e,t,n){this._method.step(e.elapsed,e.state,t,n,this._begun===e),this._begun=e,this.project(n)}_ended(e,t,n){let s=(c,u)=>this.stops.find(([,h])=>!(h(this.time+c,u)>0)),r=s(n.elapsed,n.state);if(!r)return null;let o=n.state.slice(),[a,l]=[0,n.elapsed-t.elapsed];for(let c=0;c<YA;c++){let u=.5*(a+l);this._step(t,u,o);let h=s(t.elapsed+u,o);h?[l,r]=[u,h]:a=u}return this._step(t,l,o),e.end={elapsed:t.elapsed+l,state:o,step:0,count:n.count,event:r[0]},e.end}_firstStep(e){let t=new Float64Array(e.length);this._rates(this.time,e,t);let n=o=>Math.hypot(...o.map((a,l)=>a/(this.scale[l]+Math.abs(e[l])))),[s,r]=[n(e),n(t)];return s>1e-5&&r>1e-5?.01*s/r:1e-6}_tooFar(e,t){let[n,s]=[this.time+e.sense*t,this.time+e.from.elapsed];throw new RangeError(`t = ${n} s is more than ${this.mostSteps} steps away; t = ${s} s is reached, and kept. Ask again to go on, or ask for nearer times.`)}_stuck(e){throw new RangeError(`the motion cannot be followed beyond t = ${this.time+e.elapsed} s, where it changes faster than any step. Check the parameters; losses cannot be followed far backward.`)}};function ZA(i,e){let[t,n]=[0,i.length];for(;n-t>1;){let s=t+n>>1;Math.abs(i[s].elapsed)<=e?t=s:n=s}return i[t]}function jA(i,e){let t=i.kept[i.kept.length-1];e.count<=t.count||e.count%i.spacing||(i.kept.push(e),!(i.kept.length<=WA)&&(i.spacing*=2,i.kept=i.kept.filter(({count:n})=>n%i.spacing===0)))}function so({moments:i,momentum:e,attitude:t=[1,0,0,0],epoch:n=0}){return{moments:to(i),momentum:Sn("momentum",e,3,"kg m\xB2/s"),attitude:io(no(t)),epoch:At("epoch",n,"seconds")}}function Ta(i,e){let t=Sn(i,e,3,"any unit: only the direction counts"),n=Math.max(...t.map(Math.abs));if(n>0){let s=t.map(o=>o/n),r=Math.hypot(...s);return s.map(o=>o/r)}throw new RangeError(`\`${i}\` must have a direction; got [0, 0, 0]. Give three numbers that are not all 0.`)}function Yt(i,e,t,n=!1){if(At(i,e,t)>0||n&&e===0)return e;let s=n?"not be negative":"be positive";throw new RangeError(`\`${i}\` must ${s}; got ${e}. Check its size, sign and unit, ${t}.`)}function ro(i,e,t,n,s){let[r,o,a,l]=[i[0],i[1],i[2],i[3]];s[0]=-.5*(o*e+a*t+l*n),s[1]=.5*(r*e+a*n-l*t),s[2]=.5*(r*t+l*e-o*n),s[3]=.5*(r*n+o*t-a*e)}function oo(i){let e=Math.sqrt(i[0]**2+i[1]**2+i[2]**2+i[3]**2);for(let t=0;t<4;t++)i[t]/=e}var ao=i=>Array.from(i.subarray(0,4)),lo=i=>Array.from(i.subarray(4,7)),Et=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],_u=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]],vu=(i,e)=>({"|L|\xB2":Et(e,e),momentum_space:Ea(i,e)}),co=(i,e=[])=>[1,1,1,1,i,i,i,...e];var KA=6,JA=1,QA=9,Mu=class{constructor({mean_motion:e,eccentricity:t=0,mean_anomaly_at_start:n=0}){if(this.meanMotion=Yt("mean_motion",e,"rad/s"),this.eccentricity=Yt("eccentricity",t,"1",!0),!(this.eccentricity<1))throw new RangeError(`\`eccentricity\` must be below 1; got ${t}. Only ellipses come round again.`);this.meanAnomalyAtStart=At("mean_anomaly_at_start",n,"rad")}place(e){let t=this.meanMotion*e+this.meanAnomalyAtStart,n=this.eccentricity,s=.5*eE(t-2*Math.PI*Math.round(t/(2*Math.PI)),n),[r,o]=[Math.sin(s),Math.cos(s)],a=1-n+2*n*r*r;return[(1-n-2*r*r)/a,2*Math.sqrt((1-n)*(1+n))*r*o/a,a]}};function eE(i,e){let t=Math.abs(i),n=Math.min(t+e,t/(1-e),e>0?Math.cbrt(Math.PI**2*t/e):1/0,Math.PI);for(let s=0;s<KA;s++){let r=1-e+2*e*Math.sin(.5*n)**2;n-=((1-e)*n-t+e*tE(n))/r}return n=Math.min(Math.max(n,0),Math.PI),i<0?-n:n}function tE(i){if(i>=JA)return i-Math.sin(i);let e=i**3/6,t=0;for(let n=1;n<=QA;n++)t+=e,e*=-(i*i)/((2*n+2)*(2*n+3));return t}var nE=1e-14,Ra=class{constructor({moments:e,rate:t=0,linear_drag:n=0,quadratic_drag:s=0,orbit:r=null,momentum:o,attitude:a,epoch:l}){let c=so({moments:e,momentum:o,attitude:a,epoch:l});this.moments=c.moments,this.epoch=c.epoch,this.rate=Yt("rate",t,"s/(kg m\xB2)",!0);let u=typeof n=="number"?[n,n,n]:n;this.linearDrag=Sn("linear_drag",u,3,"N m s").map(h=>Yt("linear_drag",h,"N m s",!0)),this.quadraticDrag=Yt("quadratic_drag",s,"N m s\xB2",!0),this.orbit=r===null?null:new Mu(r),this.torqued=this.orbit!==null||this.quadraticDrag>0||this.linearDrag.some(h=>h>0),this._balanced=this.torqued?["kinetic_energy","|L|\xB2"]:this.rate>0?["energy"]:[],this.orbit?.eccentricity===0&&this._balanced.push("jacobi_integral"),this._motion=new Ri({rates:this._rates(),start:[...c.attitude,...c.momentum,...this._balanced.map(()=>0)],time:this.epoch,scale:this._scales(c.momentum),tolerance:nE,project:oo})}_scales(e){let t=Math.max(...this.moments),n=Math.max(Math.hypot(...e),this.orbit?t*this.orbit.meanMotion:0)||t,s=this._balanced.map(r=>r==="|L|\xB2"?n*n:n*n/t);return co(n,s)}_rates(){return(e,t,n)=>{let s=this._at(e,[t[0],t[1],t[2],t[3]],[t[4],t[5],t[6]]),{momentum:r,velocity:o,drift:a,torque:l}=s,c=[o[0]+a[0],o[1]+a[1],o[2]+a[2]];ro(t,c[0],c[1],c[2],n);let u=_u(r,c);for(let h=0;h<3;h++)n[4+h]=u[h]+l[h];this._balanced.forEach((h,d)=>n[7+d]=this._power(h,s))}}_at(e,t,n){let s=[0,1,2].map(u=>n[u]/this.moments[u]),r=_u(n,s),o=r.map(u=>this.rate*u),a=this.orbit?this._gravity(e,t):[0,0,0],l=this.quadraticDrag*Math.hypot(s[0],s[1],s[2]),c=[0,1,2].map(u=>a[u]-(this.linearDrag[u]+l)*s[u]);return{attitude:t,momentum:n,velocity:s,torqueless:r,drift:o,pull:a,torque:c}}_gravity(e,t){let[n,s,r]=this.orbit.place(e),o=Cs(t,[n,s,0]),a=_u(o,o.map((c,u)=>this.moments[u]*c)),l=3*this.orbit.meanMotion**2/r**3;return a.map(c=>l*c)}_relative(e,t){let n=Cs(e,[0,0,1]);return t.map((s,r)=>s-this.orbit.meanMotion*n[r])}_power(e,{attitude:t,momentum:n,velocity:s,torqueless:r,drift:o,pull:a,torque:l}){let c=-Et(o,r);if(e==="|L|\xB2")return 2*Et(l,n);if(e!=="jacobi_integral")return Et(l,s)+c;let u=l.map((h,d)=>h-a[d]);return Et(u,this._relative(t,s))+c-Et(a,o)}_jacobiIntegral(e,t,n){let[s,r]=this.orbit.place(e),[o,a]=[Cs(t,[s,r,0]),Cs(t,[0,0,1])],l=this._relative(t,n),c=this.orbit.meanMotion**2,u=l.map((h,d)=>h*h+c*(3*o[d]**2-a[d]**2));return .5*Et(this.moments,u)}state(e){let t=this._motion.at(At("t",e,"seconds")),[n,s]=[ao(t),lo(t)],r=s.map((h,d)=>h/this.moments[d]),o=.5*Et(s,r),a={energy:o,kinetic_energy:o,"|L|\xB2":Et(s,s)};this.orbit&&(a.jacobi_integral=this._jacobiIntegral(e,n,r));let l=this._balanced.map((h,d)=>[h,{value:a[h],received:t[7+d]}]),c=this.torqued?{}:vu(n,s),u=this.torqued||this.rate>0?c:{energy:o,...c};return{attitude:n,momentum:s,velocity:r,energy:o,invariants:u,balances:Object.fromEntries(l),angleToMajorAxis:this._angleToMajorAxis(s)}}_angleToMajorAxis(e){if(!(Math.hypot(...e)>0))return null;let t=Math.max(...this.moments),n=e.map((s,r)=>this.moments[r]===t?s:0);return Math.atan2(Math.hypot(...e.map((s,r)=>s-n[r])),Math.hypot(...n))}};var iE=30,tf={"air-layer":["viscosity","Pa s",!1,(i,{g:e,a:t},n)=>Math.PI*i*e*t*t/(n*n)],"boundary-layer":["coefficient","W s^(5/2)",!1,(i,e,t,n)=>i*n*n*Math.sqrt(n)],"viscous-contour-friction":["coefficient","W s\xB2",!1,(i,e,t,n)=>i*n*n],"dry-contour-friction":["coefficient","1",!1,(i,{m:e,g:t,a:n},s,r)=>i*e*t*n*r],"rolling-couple":["arm","m",!1,(i,{m:e,g:t},n,s)=>i*e*t*s*Math.sin(n)],"drilling-friction":["arm","m",!0,(i,{m:e,g:t},n,s)=>i*e*t*s*n*n]};function t0(i){if(!Array.isArray(i))throw new RangeError('`dissipation` must be a list of laws, like [{law: "air-layer", viscosity: 1.8e-5}].');return i.map((e,t)=>{let n=e!==null&&typeof e=="object"&&Object.hasOwn(tf,e.law)&&tf[e.law];if(!n){let c=Object.keys(tf).join(", ");throw new RangeError(`\`dissipation[${t}].law\` must be one of ${c}; got ${JSON.stringify(e?.law)}.`)}let[s,r,o,a]=n,l=Yt(`dissipation[${t}].${s}`,e[s],r);return{vertical:o,power:(c,u,h)=>a(l,c,u,h)}})}function bu(i,e,t,n,s){let[r,o]=[0,0],[a,l]=[Math.sin(t),Math.cos(t)],c=Math.abs(a),[u,h]=[Math.min(t,Math.PI-t),Math.abs(n)/c];for(let d of e){let[f,p]=d.vertical?[a,l]:[-l/a,1],g=f*n+p*s,m=i.accelerations(f,p),x=iE*Math.sqrt(i.g/(i.a*c))/(f*m[0]+p*m[1]),y=d.power(i,u,h),v=y>=x*g*g?-g*x:-y/g;r+=f*v,o+=p*v}return[r,o]}var sE=.5772156649015329,Su=class{constructor(e){let t=rE(e);[this.near,this.far]=[[1],[]];let n=-sE;for(let o=0;o<64;o++)this.far.push(this.near[o]*(2*n-t[o])),this.near.push(this.near[o]*(o*(o+1)+e)/(o+1)**2),n+=1/(o+1);this.near.pop();let s=.25-e,r=Math.PI*Math.sqrt(Math.abs(s));this.sine=(s<0?Math.cosh(r):Math.cos(r))/Math.PI}values(e){let t=Math.sin(.5*e)**2,n=.5*Math.sin(e);if(t<=.5){let[u,h]=nf(this.near,t);return[u,n*h]}let s=Math.cos(.5*e)**2,r=Math.log(s),[o,a]=nf(this.near,s),[l,c]=nf(this.far,s);return[this.sine*(l-r*o),-n*this.sine*(c-r*a-o/s)]}};function n0(i,{m:e,a:t,C:n},s,r,o){let[a,l]=i.values(s),[c,u]=i.values(Math.PI-s),h=e*t*t*r/(n+e*t*t),d=-2*i.sine/Math.sin(s);return[(-u*o-c*h)/d,(a*h-l*o)/d]}function rE(i){let e=.25-i,t=new Array(65),n=64,[s,r]=e>=0?[Math.sqrt(e),0]:[0,Math.sqrt(-e)];t[64]=[1,-1].reduce((o,a)=>{let[l,c]=[Math.hypot(n+a*s,r),Math.atan2(a*r,n+a*s)],u=h=>Math.cos(h*c)/l**h;return o+Math.log(l)+u(2)/24-7*u(4)/960+31*u(6)/8064-127*u(8)/30720},0);for(let o=63;o>=0;o--)t[o]=t[o+1]-(2*o+1)/(o*(o+1)+i);return t}function nf(i,e){let[t,n]=[0,0];for(let s=i.length-1;s>=0;s--)n=t+e*n,t=i[s]+e*t;return[t,n]}var wu=class{constructor({m:e,a:t,b:n,A:s,C:r,g:o}){Object.assign(this,{m:e,a:t,b:n,A:s,C:r,g:o})}tiltAcceleration(e,t,n){let{m:s,a:r,b:o,A:a,C:l,g:c}=this,[u,h]=[Math.sin(e),Math.cos(e)];return((a+s*o*o)*t*t*h/u+s*r*o*t*(t-n*h/u)-(l+s*r*r)*t*n-s*c*(r*h-o*u))/(a+s*r*r+s*o*o)}tiltDerivatives(e,t,n){let{m:s,a:r,b:o,A:a,C:l,g:c}=this,[u,h]=[Math.sin(e),Math.cos(e)],[d,f,p]=[a+s*o*o,l+s*r*r,s*r*o],g=a+s*r*r+s*o*o,m=(p*t*n-d*t*t)/(u*u)+s*c*(r*u+o*h),x=2*d*t*h/u+2*p*t-p*n*h/u-f*n,y=-p*t*h/u-f*t;return[m/g,x/g,y/g]}transport(e,t,n){let{m:s,a:r,b:o,A:a,C:l}=this,c=Math.cos(e)/Math.sin(e);return this.accelerations(l*n-(a+s*o*o)*t*c-s*r*o*t,s*r*(r+o*c)*t)}accelerations(e,t){let{m:n,a:s,b:r,A:o,C:a}=this,[l,c,u]=[o+n*r*r,a+n*s*s,n*s*r],h=o*a+n*s*s*o+n*r*r*a;return[(c*e+u*t)/h,(u*e+l*t)/h]}energy(e,t,n,s){let{m:r,a:o,b:a,A:l,C:c,g:u}=this,h=(a*n-o*s)**2+(o*o+a*a)*t*t,d=o*Math.sin(e)-2*a*Math.sin(.5*e)**2;return .5*(l*(t*t+n*n)+c*s*s+r*h)+r*u*d}normalForce(e,t,n,s){let{m:r,a:o,b:a,g:l}=this,[c,u]=[Math.sin(e),Math.cos(e)];return r*(l+(o*u-a*c)*this.tiltAcceleration(e,n,s)-(o*c+a*u)*t*t)}};var oE=1e-9;function i0(i,e,t,n){let{m:s,a:r,b:o,A:a,C:l,g:c}=i,[u,h]=[Math.sin(e),Math.cos(e)],d=s*c*(r*h-o*u),[f,p]=[t,n];if(f===null){if(f=Math.sqrt(d/(a*u*h-l*u*u*o/r)),!Number.isFinite(f)||!(f>0))throw new RangeError(`no steady motion has its centre at rest at tilt ${e} rad. Give \`precession\`.`);p??=f*u*o/r}let g=At("precession",f,"rad/s")*u;if(p??=(((a+s*o*o)*h+s*r*o*u)*u*f**2-d)/(((l+s*r*r)*u+s*r*o*h)*f),!Number.isFinite(p))throw new RangeError("`spin` must be given where nothing precesses, as in straight rolling.");let m=i.tiltAcceleration(e,g,p);if(Math.abs(m)<=oE*(c/r+g*g+p*p))return[g,p];throw new RangeError(`tilt ${e} rad, \`precession\` ${f} and \`spin\` ${p} rad/s are not steady: the tilt would accelerate by ${m} rad/s\xB2. Give one of the rates only.`)}function s0(i,e,t,n,s){if(!e.length)return 0;let[r,o,a]=i.tiltDerivatives(t,n,s),[l,c]=i.transport(t,n,s),u=-(r+o*l+a*c);if(!(u>0))throw new RangeError(`the steady motion at tilt ${t} rad is unstable: no slow manifold to start on. Give another tilt.`);let[h,d]=i.accelerations(...bu(i,e,t,n,s));return(o*h+a*d)/u}var aE=1e-14,sf=1e-6,lE=.001,cE=9.80665,r0=["tilt","heading","face","contact_x","contact_y","tilt_rate","rise_rate","spin"],uo=class{constructor({start:e,epoch:t=0,...n}){let{disk:s,laws:r}=o0(n),{m:o,a,b:l,A:c,C:u,g:h}=s;this.moments=[c,c,u],this.onPlane=!0,[this.radius,this.halfThickness]=[a,l],this.epoch=At("epoch",t,"seconds"),this.thin=l===0,[this._disk,this._laws]=[s,r],this._legendre=this.thin&&!r.length?new Su(o*a*a*u/(c*(u+o*a*a))):null;let d=Math.sqrt(h/a);this._motion=new Ri({rates:this._rates(),start:[...uE(e,this.thin),0],time:this.epoch,scale:[lE,1,1,a,a,d,d,d,o*h*a],tolerance:aE,stops:this._stops(o*h)})}static rollingStart({tilt:e,precession:t=null,spin:n=null,heading:s=0,face:r=0,...o}){let{disk:a,laws:l}=o0(o);a0(At("tilt",e,"rad"),a.b===0);let c=i0(a,e,t,n);return[e,s,r,0,0,s0(a,l,e,...c),...c]}_stops(e){let t={flat:(n,s)=>Math.sin(s[0])-sf,"lift-off":(n,s)=>this._disk.normalForce(s[0],s[5],s[6],s[7])/e};return this.thin?t:{...t,"on edge":(n,s)=>Math.cos(s[0])}}_rates(){let[e,t]=[this._disk,this._laws];return(n,s,r)=>{let[o,a,l,c,u]=[s[0],s[1],s[5],s[6],s[7]],h=c/Math.sin(o),d=u-h*Math.cos(o),[f,p]=bu(e,t,o,c,u),[g,m]=e.accelerations(f,p),[x,y]=e.transport(o,c,u);r[0]=l,r[1]=h,r[2]=u+2*h*Math.sin(.5*o)**2,r[3]=-e.a*d*Math.cos(a),r[4]=-e.a*d*Math.sin(a),r[5]=e.tiltAcceleration(o,c,u),r[6]=x*l+g,r[7]=y*l+m,r[8]=f*c+p*u}}get end(){return this._motion.end()}state(e){let t=At("t",e,"seconds"),[n,s,r,o,a,l,c,u,h]=this._motion.at(t),d=this._disk,[f,p]=[Math.sin(n),Math.cos(n)],[g,m,x]=[-Math.sin(s),Math.cos(s),d.b],y=r-s,v=[Math.cos(y)*l+Math.sin(y)*c,Math.cos(y)*c-Math.sin(y)*l,u],M=d.energy(n,l,c,u),w=this._motion.end(e>=this.epoch);return{attitude:hE(n,s,r),momentum:v.map((A,_)=>this.moments[_]*A),velocity:v,energy:M,tilt:n,heading:s,face:r,invariants:this._invariants(M,n,c,u),balances:this._laws.length?{energy:{value:M,received:h}}:{},contact:[o,a],center:[o+g*(d.a*p-x*f),a+m*(d.a*p-x*f),d.a*f+x*p],normalForce:d.normalForce(n,l,c,u),parts:[n,s,r,o,a,l,c,u],ended:w&&Math.abs(e-this.epoch)>=Math.abs(w.time-this.epoch)?w.event:null}}_invariants(e,t,n,s){if(this._laws.length)return{};if(!this._legendre)return{energy:e};let[r,o]=n0(this._legendre,this._disk,t,n,s);return{energy:e,linear_integral_1:r,linear_integral_2:o}}};function o0({mass:i,radius:e,half_thickness:t=0,axial_moment:n,diametral_moment:s,gravity:r=cE,dissipation:o=[]}){let[a,l,c]=[Yt("mass",i,"kg"),Yt("radius",e,"m"),Yt("gravity",r,"m/s\xB2")],u=Yt("half_thickness",t,"m",!0);if(u>l)throw new RangeError(`\`half_thickness\` must be at most the radius, ${l} m; got ${u}. Check units.`);let h=Yt("axial_moment",n??.5*a*l*l,"kg m\xB2"),d=Yt("diametral_moment",s??a*(.25*l*l+u*u/3),"kg m\xB2");if(h>2*d*(1+1e-12))throw new RangeError(`\`axial_moment\` must be at most twice \`diametral_moment\`; got ${h} and ${d} kg m\xB2. Check units.`);return{disk:new wu({m:a,a:l,b:u,A:d,C:h,g:c}),laws:t0(o)}}function uE(i,e){let t=Sn("start",i,r0.length,`SI units: ${r0.join(", ")}`);return a0(t[0],e),t}function a0(i,e){let t=e?Math.PI:.5*Math.PI;if(!(i>0&&i<t&&Math.sin(i)>sf))throw new RangeError(`the tilt at the start must lie between ${sf} rad and ${e?"\u03C0 less that":"\u03C0/2 for a thick disk"}; got ${i} rad. A disk that lies flat does not roll: start at a small tilt, such as 0.1.`)}function hE(i,e,t){let[n,s]=[Math.sin(.5*i),Math.cos(.5*i)],[r,o]=[.5*t,e-.5*t];return[s*Math.cos(r),n*Math.cos(o),n*Math.sin(o),s*Math.sin(r)]}var dE=1e-14,Ca=class{constructor({moments:e,rotor:t,rotor_moment:n=null,rotor_drive:s="constant-rate",axis:r=null,momentum:o,attitude:a,epoch:l}){let c=so({moments:e,momentum:o,attitude:a,epoch:l});if(this.moments=c.moments,this.epoch=c.epoch,this.rotor=Sn("rotor",t,3,"kg m\xB2/s"),this.rotorMoment=n===null?null:Yt("rotor_moment",n,"kg m\xB2"),!["constant-rate","free"].includes(s))throw new RangeError(`\`rotor_drive\` must be "constant-rate" or "free"; got ${JSON.stringify(s)}.`);this.free=s==="free";let u=Math.hypot(...this.rotor)>0;this.axis=r===null?u&&Ta("rotor",this.rotor):Ta("axis",r);let h=Math.max(Math.hypot(...c.momentum),Math.hypot(...this.rotor))||Math.max(...this.moments);this._motion=new Ri({rates:this._rates(),start:[...c.attitude,...c.momentum],time:this.epoch,scale:co(h),tolerance:dE,project:oo})}_rates(){let[e,t,n]=this.moments,[s,r,o]=this.rotor;return(a,l,c)=>{let[u,h,d]=[l[4],l[5],l[6]],[f,p,g]=[(u-s)/e,(h-r)/t,(d-o)/n];ro(l,f,p,g,c),c[4]=h*g-d*p,c[5]=d*f-u*g,c[6]=u*p-h*f}}state(e){let t=this._motion.at(At("t",e,"seconds")),[n,s]=[ao(t),lo(t)],r=s.map((c,u)=>c-this.rotor[u]),o=r.map((c,u)=>c/this.moments[u]),a=.5*Et(r,o),l={energy:a,...vu(n,s)};return{attitude:n,momentum:s,velocity:o,energy:a,invariants:l,rotorRate:this.rotorRate(o)}}rotorRate(e){return this.rotorMoment===null||!this.axis?null:Et(this.rotor,this.axis)/this.rotorMoment-(this.free?Et(e,this.axis):0)}};var ho=1e-12,fE=1e-12;function l0(i,e,t,n){if(e===0)return["Euler's |\u03A0|\xB2",s=>Et(s,s)];if(pE(i,t))return["Lagrange's \u03A0\xB7\u03C7",s=>Et(s,t)];for(let s=0;s<3;s++){let[r,o]=c0(s);if(!u0(i[r],i[o])||Math.abs(t[s])>ho)continue;let a={moments:i,axis:t,i:r,j:o,k:s,strength:e/i[s]};if(Math.abs(i[r]/2-i[s])<=ho*i[s])return["Kovalevskaya's integral",gE(a)];if(Math.abs(i[r]/4-i[s])<=ho*i[s])return["Goryachev and Chaplygin's integral",mE(...n)?xE(a):()=>NaN]}return null}var c0=i=>[(i+1)%3,(i+2)%3],u0=(i,e)=>Math.abs(i-e)<=ho*i;function pE(i,e){let t=Math.max(...i);return t-Math.min(...i)<=ho*t?!0:[0,1,2].some(n=>{let[s,r]=c0(n);return u0(i[s],i[r])&&Math.abs(e[s])+Math.abs(e[r])<=ho})}var mE=(i,e)=>Math.abs(Et(i,e))<=fE*Math.hypot(...i)*Math.hypot(...e);function gE({moments:i,axis:e,i:t,j:n,strength:s}){return(r,o)=>{let[a,l]=[r[t]/i[t],r[n]/i[n]],c=a*a-l*l-s*(o[t]*e[t]-o[n]*e[n]),u=2*a*l-s*(o[t]*e[n]+o[n]*e[t]);return c*c+u*u}}function xE({moments:i,axis:e,i:t,j:n,k:s,strength:r}){return(o,a)=>{let l=o.map((c,u)=>c/i[u]);return l[s]*(l[t]**2+l[n]**2)-r*Et(l,e)*a[s]}}var yE=1e-14,Ia=class{constructor({moments:e,mgl:t,axis:n=[0,0,1],momentum:s,attitude:r,epoch:o}){let a=so({moments:e,momentum:s,attitude:r,epoch:o});this.moments=a.moments,this.epoch=a.epoch,this.mgl=At("mgl",t,"N m"),this.axis=Ta("axis",n);let l=Cs(a.attitude,[0,0,1]);this._third=l0(this.moments,this.mgl,this.axis,[a.momentum,l]);let c=Math.max(...this.moments),u=Math.max(Math.hypot(...a.momentum),Math.sqrt(Math.abs(this.mgl)*c))||c;this._motion=new Ri({rates:this._rates(),start:[...a.attitude,...a.momentum],time:this.epoch,scale:co(u),tolerance:yE,project:oo})}_rates(){let[e,t,n]=this.moments,[s,r,o]=this.axis.map(a=>this.mgl*a);return(a,l,c)=>{let[u,h,d,f]=[l[0],l[1],l[2],l[3]],[p,g,m]=[l[4],l[5],l[6]],[x,y,v]=[p/e,g/t,m/n];ro(l,x,y,v,c);let[M,w,A]=[2*(h*f-u*d),2*(d*f+u*h),u*u-h*h-d*d+f*f];c[4]=g*v-m*y+w*o-A*r,c[5]=m*x-p*v+A*s-M*o,c[6]=p*y-g*x+M*r-w*s}}state(e){let t=this._motion.at(At("t",e,"seconds")),[n,s]=[ao(t),lo(t)],r=s.map((c,u)=>c/this.moments[u]),o=Cs(n,[0,0,1]),a=.5*Et(s,r)+this.mgl*Et(o,this.axis),l={energy:a,"|P|\xB2":Et(o,o),"\u03A0\xB7P":Et(s,o)};return this._third&&(l[this._third[0]]=this._third[1](s,o)),{attitude:n,momentum:s,velocity:r,energy:a,invariants:l}}};var Pa=2*Math.PI,_E=[.08,.25,.5,.75],vE=2400,rf=160,ME=.05,ti=i=>[0,1,2].sort((e,t)=>i[e]-i[t]||e-t);function bE(i){let[e,t,n]=ti(i);return i[e]<i[t]&&i[t]<i[n]}function or(i,e,t=vE){let n=ti(i),[s,r,o]=n.map(y=>i[y]),[a,l,c]=n.map(y=>e[y]/Math.hypot(...e));if(s===o)return null;let u=s*(o-r)*c*c-o*(r-s)*a*a;if(u===0&&s<r&&r<o)return null;let h=u>0,d=h?s*(o-r)/(r*(o-s)):o*(r-s)/(r*(o-s)),f=h?a:c,p=Math.sqrt(l*l+(d>0?f*f/d:0)),g=Math.sqrt(f*f+d*l*l);if(g===0||!(p<=1+1e-12))return null;let m=Math.sign(h?c:a)||1,x=[];for(let y of SE(Math.min(p,1),t)){let[v,M]=[g*Math.cos(y),p*Math.sin(y)],w=m*Math.sqrt(Math.max(0,1-v*v-M*M)),A=[0,0,0];[A[n[0]],A[n[1]],A[n[2]]]=h?[v,M,w]:[w,M,v],x.push(...A)}return x}function SE(i,e){let t=[];for(let s=0;s<e;s++)t.push(Pa*s/e);let n=Math.sqrt(Math.max(0,1-i*i));for(let s=.02*n;n>0&&s<.5;s+=ME*Math.max(s,.4*n)){let r=Math.asin(s);for(let o of[.25*Pa,.75*Pa])t.push(o-r,o+r)}return t.push(Pa),t.sort((s,r)=>s-r)}function d0(i){let e=ti(i),[t,n,s]=e.map(o=>i[o]);if(t===s)return[];let r=[t<n,t===s,n<s];return e.flatMap((o,a)=>[1,-1].map(l=>{let c=[0,0,0];return c[o]=l,{at:c,verdict:r[a]?"stable":"unstable"}}))}function f0(i){let e=ti(i),[t,n,s]=e.map(a=>i[a]),r=[];if(t===s)return r;let o=Math.atan2(Math.sqrt((s-n)*t),Math.sqrt((n-t)*s));for(let[a,l,c]of[[e[2],e[0],o],[e[0],e[2],.5*Math.PI-o]])if(!(c<1e-9))for(let u of _E){let h=[0,0,0];[h[a],h[l]]=[Math.cos(u*c),Math.sin(u*c)],r.push(...La(i,h))}return r}function La(i,e){let t=or(i,e,rf);return t?[...of(t),...of(t.map(n=>-n))]:[]}function p0(i){if(!bE(i))return[];let e=ti(i),[t,n,s]=e.map(a=>i[a]),r=Math.atan2(Math.sqrt((s-n)*t),Math.sqrt((n-t)*s)),o=[];for(let a of[1,-1]){let l=[];for(let c=0;c<=rf;c++){let u=[0,0,0],h=Pa*c/rf;u[e[1]]=Math.cos(h),u[e[0]]=a*Math.sin(h)*Math.sin(r),u[e[2]]=Math.sin(h)*Math.cos(r),l.push(...u)}o.push(...of(l))}return o}var Ci=64,h0=9;function m0(i,e,t){if(!(t>0))return[];let n=l=>l.reduce((c,u,h)=>c+(t*u-e[h])**2/i[h],0),s=[],[r,o]=[1/0,-1/0];for(let l=0;l<6;l++){let c=[];for(let u=0;u<=Ci;u++)for(let h=0;h<=Ci;h++){let d=[0,0,0];d[l%3]=l<3?1:-1,d[(l+1)%3]=Math.tan((2*u/Ci-1)*.25*Math.PI),d[(l+2)%3]=Math.tan((2*h/Ci-1)*.25*Math.PI);let f=Math.hypot(...d),p=d.map(m=>m/f),g=n(p);[r,o]=[Math.min(r,g),Math.max(o,g)],c.push([p,g])}s.push(c)}let a=[];if(!(o-r>1e-12*Math.abs(o)))return a;for(let l of s)for(let c=0;c<Ci;c++)for(let u=0;u<Ci;u++){let[h,d,f,p]=[l[c*(Ci+1)+u],l[(c+1)*(Ci+1)+u],l[(c+1)*(Ci+1)+u+1],l[c*(Ci+1)+u+1]];for(let g of[[h,d,f],[h,f,p]])wE(g,r,o,a)}return a}function wE(i,e,t,n){let s=i.map(([,l])=>l),r=(t-e)/(h0+1),o=Math.max(1,Math.ceil((Math.min(...s)-e)/r)),a=Math.min(h0,Math.floor((Math.max(...s)-e)/r));for(let l=o;l<=a;l++){let c=e+l*r,u=[];for(let h=0;h<3;h++){let[[d,f],[p,g]]=[i[h],i[(h+1)%3]];if(f<c==g<c)continue;let m=(c-f)/(g-f),x=d.map((v,M)=>v+m*(p[M]-v)),y=Math.hypot(...x);u.push(x.map(v=>v/y))}u.length===2&&n.push(...u[0],...u[1])}}function of(i){let e=[];for(let t=0;t+5<i.length;t+=3)e.push(...i.slice(t,t+6));return e}var af={"-":"\u207B",0:"\u2070",1:"\xB9",2:"\xB2",3:"\xB3",4:"\u2074",5:"\u2075",6:"\u2076",7:"\u2077",8:"\u2078",9:"\u2079"};function et(i,e=6){if(i===0)return"0";if(!Number.isFinite(i))return"\u2014";let t=Math.abs(i);if(t>=.001&&t<1e6){let o=t>=10**e?String(Number(i.toPrecision(e))):i.toPrecision(e);return Xt(o.replace("-","\u2212"))}let[n,s]=i.toExponential(e-1).split("e"),r=[...s.replace("+","")].map(o=>af[o]).join("");return Xt(`${n}\xB710${r}`.replace("-","\u2212"))}var AE=[[31557600,"yr"],[86400,"d"],[3600,"h"],[60,"min"]],EE=[[1,"s"],[.001,"ms"],[1e-6,"\xB5s"],[1e-9,"ns"],[1e-12,"ps"],[1e-15,"fs"]];function lf(i){return AE.find(([e])=>i>=3*e)??EE.find(([e])=>i>=.3*e)??null}function wn(i,e){let[t,n]=lf(e)??[null];return t?`${Xt((i/t).toFixed(TE(e/t)))} ${W(n)}`:`${et(i,4)} s`}var bt=(i,e)=>Xt(i.toPrecision(e)),Au=(i,e)=>W("{least} to {most}",{least:g0(i),most:g0(e)}),g0=i=>`${et(i*180/Math.PI,4)}\xB0`,fi=(i,e=4)=>W("{number} rpm",{number:et(i*30/Math.PI,e)}),TE=i=>Math.max(0,Math.min(4,4-Math.ceil(Math.log10(Math.max(i,1e-9))))),He=i=>String(i);var cf=Math.PI/30,x0=Math.PI/180;function nn(i,e){let[t,n,s]=[0,1,2].map(r=>i[(e+r)%3]);return{rate:Math.hypot(...i),tilt:Math.atan2(Math.hypot(n,s),t),around:n||s?Math.atan2(s,n):0}}function v0(i,{rate:e,tilt:t,around:n}){let s=[0,0,0];return s[i]=e*Math.cos(t),s[(i+1)%3]=e*Math.sin(t)*Math.cos(n),s[(i+2)%3]=e*Math.sin(t)*Math.sin(n),s}var Is={rate:1,about:1,tilt:1,angular_velocity:3,momentum:3,attitude:4},Gn=(i,e)=>`[${i.map(t=>`"${He(t)} ${e}"`).join(", ")}]`,Ps=i=>i.map(Math.abs).reduce((e,t,n,s)=>t>s[e]?n:e,0),Ls=i=>i.map((e,t)=>({key:`body.moments.${t}`,label:W("moment of inertia I{axis}",{axis:"\u2081\u2082\u2083"[t]}),unit:"kg m\xB2",value:e,...RE(i,t)}));function RE(i,e){let[t,n]=[i[(e+1)%3],i[(e+2)%3]],[s,r]=[Math.abs(t-n),t+n];return{low:Math.max(s,.001*r),high:r,log:!0}}function Ns({velocity:i,about:e,around:t}){let{rate:n,tilt:s}=nn(i,e),r=n<.001*cf||n>1e6*cf;return[{key:"spin.rate",label:"spin rate |\u03A9|",unit:r?"rad/s":"rpm",si:r?1:cf,value:n,log:!0,low:n/20||.1,high:20*n||100},{key:"spin.about",label:"tilt counted from",value:e,choices:[0,1,2].map(o=>[o,W("axis {axis}",{axis:o+1})])},{key:"spin.tilt",label:"tilt of the spin",unit:"\xB0",si:x0,value:s,low:0,high:Math.PI,power:2},{key:"spin.around",label:W("tilted towards (0\xB0 is axis {axis})",{axis:(e+1)%3+1}),unit:"\xB0",si:x0,value:s>0?nn(i,e).around:t,low:-Math.PI,high:Math.PI}]}function Ds(i,e,t){let[,n,s]=e.split(".");if(n==="moments"){let o=i.moments.map((a,l)=>l===Number(s)?t:a);return{...i,moments:o,momentum:null}}if(n==="about")return{...i,about:t,around:nn(i.velocity,t).around};let r={...nn(i.velocity,i.about)};return r.tilt>0||(r.around=i.around),r[n]=t,{...i,velocity:v0(i.about,r),around:r.around,momentum:null}}function Us(i,{body:e={},spin:t={}},n=[0,0,0]){let s={...i};if(e.moments&&(s={...s,moments:IE(e.moments),momentum:null}),t.attitude&&(s.attitude=t.attitude.map(Number)),t.momentum){let d=t.momentum.map(Number),f=d.map((p,g)=>(p-n[g])/s.moments[g]);return{...s,momentum:d,velocity:f,around:nn(f,s.about).around}}if(t.angular_velocity){let d=t.angular_velocity.map(Number);return{...s,momentum:null,velocity:d,around:nn(d,s.about).around}}if(["rate","about","tilt"].every(d=>t[d]===void 0))return s;if(t.about!==void 0&&![1,2,3].includes(t.about))throw new RangeError(`spin.about must be 1, 2 or 3, a principal axis; got ${t.about}.`);let r=CE(s.moments),o=t.about===void 0?r.findIndex(d=>d[s.about]!==0):t.about-1,a=nn(r.map(d=>M0(d,s.velocity)),o),l={rate:t.rate??a.rate,tilt:t.tilt??a.tilt,around:t.tilt===void 0?a.around:0},c=v0(o,l),u=[0,1,2].map(d=>r.reduce((f,p,g)=>f+p[d]*c[g],0)),h=r[o].findIndex(d=>d!==0);return{...s,about:h,around:nn(u,h).around,momentum:null,velocity:u}}var M0=(i,e)=>i.reduce((t,n,s)=>t+n*e[s],0);function CE(i){let e=ti(i),t=(e[1]-e[0])*(e[2]-e[0])*(e[2]-e[1])<0;return e.map((n,s)=>[0,1,2].map(r=>r===n?t&&s===2?-1:1:0))}function IE(i){let e=i[0]+i[1]+i[2];if(i.every(t=>t>0&&2*t<=e*(1+1e-9)))return i;throw new RangeError(`Moments must be positive and satisfy I1 + I2 \u2265 I3; got ${i.join(", ")} kg m\xB2. No rigid body has these.`)}var ni=({moments:i,velocity:e,momentum:t},n=[0,0,0])=>t??e.map((s,r)=>s*i[r]+n[r]),[PE,y0]=[60,24];function Eu(i,e,t=[0,0,1]){let n=i.state(i.epoch),s=2*Math.PI/(Math.hypot(...n.velocity)||1)/y0,[r,o]=NE(t),[a,l]=[[],[]],[c,u]=[0,null],h=PE*y0;for(let v=0;v<=h;v++){let M=e(i.state(i.epoch+v*s)),[w,A,_]=[r,o,t].map(I=>M0(I,M));a.push(Math.atan2(Math.hypot(w,A),_));let b=Math.atan2(A,w);u!==null&&(c+=Math.atan2(Math.sin(b-u),Math.cos(b-u))),u=b,l.push(c)}let[d,f]=[Math.min(...a),Math.max(...a)],p=LE(a),[g,m,x]=p.length>1?[p[0],p.at(-1),p.length-1]:[0,h,null],y=(_0(l,m)-_0(l,g))/((m-g)*s);return{least:d,most:f,swing:x?(m-g)*s/x:null,around:y}}var _0=(i,e)=>{let t=Math.min(Math.floor(e),i.length-2);return i[t]+(e-t)*(i[t+1]-i[t])};function LE(i){let e=[];for(let t=1;t+1<i.length;t++){let[n,s,r]=[i[t-1],i[t],i[t+1]];s>n&&s>=r&&n-2*s+r<0&&e.push(t+.5*(n-r)/(n-2*s+r))}return e}function NE([i,e,t]){let n=Math.abs(t)<.9?[0,0,1]:[1,0,0],s=[n[1]*t-n[2]*e,n[2]*i-n[0]*t,n[0]*e-n[1]*i],r=Math.hypot(...s),[o,a,l]=s.map(c=>c/r);return[[o,a,l],[e*l-t*a,t*o-i*l,i*a-e*o]]}function Na([i,e,t,n],[s,r,o]){let[a,l,c]=[2*(t*o-n*r),2*(n*s-e*o),2*(e*r-t*s)];return[s+i*a+t*c-n*l,r+i*l+n*a-e*c,o+i*c+e*l-t*a]}var DE=2e3,UE=5*Math.PI/180,FE=["rate","spin.tilt","spin.rate"],OE={body:{moments:3},system:{kind:0,damping:1,sink_rate:1,linear_drag:1,quadratic_drag:1},spin:Is};function BE({moments:i,rate:e=0,linear_drag:t=0,quadratic_drag:n=0,momentum:s,attitude:r=[1,0,0,0],epoch:o=0}){let a=s.map((c,u)=>c/i[u]),l=Ps(a);return{moments:i,velocity:a,attitude:r,epoch:o,about:l,around:nn(a,l).around,momentum:s,rate:e,linear_drag:t,quadratic_drag:n}}function kE(i){let e=1/(Math.hypot(...ni(i))||1);return[{key:"rate",label:"losses inside, \u03B1",unit:"s/(kg m\xB2)",value:i.rate,low:0,high:5*Math.max(i.rate,.02*e),power:2},...Ls(i.moments),...Ns(i)]}var zE=(i,e,t)=>e==="rate"?{...i,rate:t}:Ds(i,e,t),GE=i=>new Ra({...i,momentum:ni(i)}),VE=({moments:i,rate:e,linear_drag:t,quadratic_drag:n,velocity:s,attitude:r})=>({body:{moments:i},system:{kind:"damped-body",sink_rate:e,linear_drag:t,quadratic_drag:n},spin:{angular_velocity:s,attitude:r}});function HE(i,e){let{system:t={}}=e,n={...i};for(let[o,a]of[["sink_rate","rate"],["linear_drag","linear_drag"],["quadratic_drag","quadratic_drag"]])t[o]!==void 0&&(n[a]=t[o]);let s=Us(n,e);if(t.damping===void 0)return s;let r=Math.hypot(...ni(s));return{...s,rate:r>0?t.damping/r:0}}function WE(i,e){let{moments:t,rate:n,linear_drag:s,quadratic_drag:r,velocity:o,attitude:a}=i,l=Math.hypot(...ni(i)),c=n>0&&l>0?`damping = ${He(n*l)}
`:"",u=s>0?`linear_drag = "${He(s)} N*m*s"
`:"",h=r>0?`quadratic_drag = "${He(r)} N*m*s^2"
`:"";return!c&&!u&&!h?null:`[body]
moments = ${Gn(t,"kg*m^2")}

[system]
kind = "damped-body"
${c}${u}${h}
[spin]
angular_velocity = ${Gn(o,"rad/s")}
attitude = [${a.map(He).join(", ")}]

[time]
until = "${He(e)} s"
`}function qE({moments:i,velocity:e,rate:t},n){let{energy:s,momentum:r}=n.state(n.epoch),o=Math.hypot(...r);if(!(o>0))return[["what it does","at rest"]];let[a,,l]=ti(i).map(d=>i[d]),c=[["what it does",t>0&&a<l?"loses energy and ends spinning about its axis of largest moment":"keeps |L|"]],u=o*o/(2*l);c.push(["energy it can lose inside",`${et(100*(s-u)/s,3)} %`]);let h=t>0?b0(n,Math.hypot(...e)):null;return h!==null&&c.push(["within 5\xB0 of the flat spin after",wn(h,h)]),c}var XE=({velocity:i,rate:e},t)=>e>0?b0(t,Math.hypot(...i)):null;function b0(i,e){let t=2*Math.PI/e/4,n=null;for(let s=0;s<4*DE;s++){let{angleToMajorAxis:r}=i.state(i.epoch+s*t);if(!(r<UE))n=null;else{if((n??=s*t)<.5*s*t)return n;if(n===0)return 0}}return n}var df={};cs(df,{asSpec:()=>eT,changed:()=>JE,controls:()=>KE,facts:()=>iT,from:()=>ZE,keys:()=>YE,make:()=>QE,toml:()=>nT,withSpec:()=>tT});var hf=Math.PI/180,$E=.02,Da={"air-layer":["viscosity","Pa*s","viscosity of the air"],"boundary-layer":["coefficient","W*s^2.5","loss in the boundary layer"],"viscous-contour-friction":["coefficient","W*s^2","viscous friction of the contact"],"dry-contour-friction":["coefficient","","dry friction of the contact"],"rolling-couple":["arm","m","lever arm of rolling friction"],"drilling-friction":["arm","m","lever arm of drilling friction"]},YE={system:{kind:0,mass:1,radius:1,thickness:1,gravity:1,tilt:1},dissipation:Object.fromEntries(Object.keys(Da).map(i=>[i,1]))};function ZE({mass:i,radius:e,half_thickness:t,diametral_moment:n,axial_moment:s,gravity:r,dissipation:o,start:a,epoch:l=0}){let u=Math.abs(s-.5*i*e**2)<1e-12*s&&Math.abs(n-i*(.25*e**2+t**2/3))<1e-12*n?null:[n/(i*e**2),s/(i*e**2)],h={mass:i,radius:e,half_thickness:t,shares:u,gravity:r,dissipation:o,tilt:a[0],heading:a[1],face:a[2],start:a,epoch:l};return{...h,moments:Ru(h),steady:jE(h)}}var Ru=({shares:i,mass:e,radius:t,half_thickness:n})=>{let[s,r]=i?i.map(o=>o*e*t**2):[e*(.25*t**2+n**2/3),.5*e*t**2];return[s,s,r]},S0=i=>{let[e,,t]=Ru(i),{mass:n,radius:s,half_thickness:r,gravity:o,dissipation:a}=i,l=Object.entries(a).map(([c,u])=>({law:c,[Da[c][0]]:u}));return{mass:n,radius:s,half_thickness:r,gravity:o,diametral_moment:e,axial_moment:t,dissipation:l}},w0=i=>uo.rollingStart({...S0(i),tilt:i.tilt,heading:i.heading,face:i.face});function jE(i){try{let e=w0(i),t=Math.hypot(...e.slice(6));return[6,7].every(n=>Math.abs(e[n]-i.start[n])<$E*t)}catch{return!1}}function KE(i){let{tilt:e,radius:t,half_thickness:n,mass:s,gravity:r,dissipation:o}=i;return[{key:"tilt",label:"tilt of the face at first",unit:"\xB0",si:hf,value:e,low:Math.min(e,hf),high:80*hf,log:!0},{key:"radius",label:"radius",unit:"mm",si:.001,value:t,low:t/5,high:5*t,log:!0},{key:"thickness",label:"thickness",unit:"mm",si:.001,value:2*n,low:0,high:t},{key:"mass",label:"mass",unit:"g",si:.001,value:s,low:s/20,high:20*s,log:!0},{key:"gravity",label:"gravity",unit:"m/s\xB2",value:r,low:r/10,high:3*r,log:!0},...Object.entries(o).map(([a,l])=>({key:`law.${a}`,label:Da[a][2],unit:Da[a][1].replace("*"," ").replace("^2.5","^(5/2)").replace("^2","\xB2"),value:l,low:l/100,high:100*l,log:!0}))]}function JE(i,e,t){let[n,s]=e.split(".");return Tu(s?{...i,dissipation:{...i.dissipation,[s]:t}}:n==="thickness"?{...i,half_thickness:.5*t}:{...i,[n]:t})}function Tu(i){let e={...i,steady:!0,epoch:0};return{...e,start:w0(e),moments:Ru(e)}}var QE=i=>new uo({...S0(i),start:i.start,epoch:i.epoch}),eT=({mass:i,radius:e,half_thickness:t,gravity:n,tilt:s,dissipation:r})=>({system:{kind:"euler-disk",mass:i,radius:e,thickness:2*t,gravity:n,tilt:s},dissipation:r});function tT(i,{system:e={},dissipation:t={}}){let n={...i,dissipation:{...i.dissipation,...t}};for(let[s,r]of Object.entries(n.dissipation))r===0&&delete n.dissipation[s];for(let s of["mass","radius","gravity","tilt"])e[s]!==void 0&&(n[s]=e[s]);return e.thickness!==void 0&&(n.half_thickness=.5*e.thickness),Tu(n)}function nT(i,e){if(!i.steady)return null;let{mass:t,radius:n,half_thickness:s,shares:r,gravity:o,tilt:a,heading:l,dissipation:c}=i,[u,,h]=Ru(i),d=r?`axial_moment = "${He(h)} kg*m^2"
diametral_moment = "${He(u)} kg*m^2"
`:"",f=Object.entries(c).map(([p,g])=>{let[m,x]=Da[p];return`{ law = "${p}", ${m} = ${x?`"${He(g)} ${x}"`:He(g)} }`});return`[system]
kind = "euler-disk"
mass = "${He(t)} kg"
radius = "${He(n)} m"
thickness = "${He(2*s)} m"
${d}gravity = "${He(o)} m/s^2"
tilt = "${He(a)} rad"
heading = "${He(l)} rad"
dissipation = [${f.join(", ")}]

[time]
until = "${He(e)} s"
`}function iT(i,e){let t=e.state(e.epoch),n=t.parts[6]/Math.sin(t.tilt),s=2*Math.PI/Math.abs(n),r=e.state(e.epoch+20*s),o=r.balances.energy?r.balances.energy.received-t.balances.energy.received:0,a=[["contact goes round every",`${et(s,4)} s`],["energy at first",`${et(t.energy,5)} J`],["energy less losses, change in 20 rounds",et(Math.abs(r.energy-o-t.energy)/t.energy,2)]];return o&&a.push(["lost in 20 rounds",`${et(-100*o/t.energy,3)} %`]),r.ended&&a.push(["ends",r.ended==="flat"?"flat on the table, within 20 rounds":W("by {event}, within 20 rounds",{event:W(r.ended)})]),a}var If={};cs(If,{asSpec:()=>xR,changed:()=>pR,controls:()=>dR,dragged:()=>lR,event:()=>MR,facts:()=>vR,first:()=>cR,from:()=>hR,keys:()=>uR,make:()=>gR,toml:()=>_R,withDirection:()=>mR,withSpec:()=>yR});var Zt=(i,e)=>i>e?i:e,Ii=(i,e)=>i<e?i:e;function E0(i){let e=Math.round(i);return(e-i===.5&&e%2!==0?e-1:e)+0}var A0=new DataView(new ArrayBuffer(8));function sn(i){if(i===0)return 0;A0.setFloat64(0,i);let e=A0.getUint32(0)>>>20&2047;return e===0?sn(i*2**100)-100:e-1022}function Je(i,e){let t=Math.max(-1e3,Math.min(1e3,e)),n=i*2**t;return e===t?n:Je(n,e-t)}var T0=2e-8,sT=20,rT=3;function fo(i,e,t,n){let{0:s,1:r}=bn(i),o=s*n+r*(t+n)+e*t;return[-(s*t),1-o*(1-.5*o)]}function Cu(i,e,t,n){let{0:s,1:r,2:o}=Ki(i,n),{0:a,1:l}=mt((1-t)*o,s),{0:c,1:u}=mt(a,e[0]),h;({0:c,1:h}=Ei(c,r+(e[1]+(l+u))));let d=t*E0(c);return[c-d,h,t*o+d]}function Ua(i,e){let t=1+Math.sqrt(e),n=.5/((1+e)*t*t),s=n*i,r=s*s*(s*s);return n*(1+r*(2+r*(15+r*(150+r*1707))))}function Iu(i,e){let t=e*e*(e*e),n=2*(e+t+t*t*e);return Ae(i,[-i[0]*(n*(2+n)/((1+n)*(1+n))),0])}function oT(i,e,t,n,s){let r=me(i,e),o=Ae(t,r);return n=de(me(n,Te(it(t,r),o)),.5),[de(Ae(i,e),.5),Rs(r),de(Te(Ln(o),t),.25),n,Ae(s,n)]}function R0(i,e,t){let n=de(Ae(i,e),.5),s=.5*(i[0]-e[0]+(i[1]-e[1])),r=it(t,Ln(n)),o=r[0]+r[1]+s*s;return[s/n[0],o/(2*n[0]*n[0]+o),n]}function aT(i,e,t,n,s){let r=.5*n*e,o=r+r*(.25*(e*e-.5*i*i));return[Ae(t,[-.25*t[0]*i*i,0]),Ae(s,[o,0])]}function lT(i,e,t){let n=Ii(sn(i[0]),0*i[0]),s=Je(1,-n),r=[1,0];return[[de(i,s),de(e,s),de(de(t,s),s),r,r],n]}function cT(i){let{0:e,1:t,2:n,3:s,4:r}=i;return oT(e,t,n,s,r)}function uT(i){let{0:e,1:t}=R0(i[0],i[1],i[2]);return Math.abs(e)<T0&&Math.abs(t)<T0}function hT(i){let{0:e,1:t,2:n}=R0(i[0],i[1],i[2]);return aT(e,t,n,i[3][0],i[4])}function Fa(i,e,t){let{0:n,1:s}=lT(i,e,t),r=n;for(let l=0;l<sT&&!(l>=rT&&uT(r));l++)r=cT(r);let{0:o,1:a}=hT(r);return[de(o,Je(1,s)),a]}function ff(i,e){let t=i.start[0],{0:n,1:s,2:r,3:o,4:a,5:l,6:c,7:u,8:h,9:d}=i.series,{0:f,1:p}=Ki(i.first,e),{0:g,1:m}=Ki(i.second,e),x=f+(p-t),y=g+(m+t),{0:v,1:M}=tn(x-It(x)),{0:w,1:A}=tn(y-It(y)),_=M*A+v*w,b=w*M-A*v,I=b+b,T=1-I*b,L=I*_,D=n+T*(s+T*r),O=L*(o+T*a),P=l+T*(c+T*u),B=L*(h+T*d);return[M*D-v*O,M*O+v*D,A*P-w*B,A*B+w*P]}function pf(i,e){let{1:t,2:n,3:s,4:r}=i.nome,{0:o,1:a}=Ki(i.first,e),{0:l,1:c,2:u}=Cu(i.second,i.start,r,e);u=i.parity+u,u=u-4*It(.25*u);let h=o-.25*u;h=h-It(h)+(a-l*s);let d=l<0?-1:1,f=l*d,p=c*d,{0:g,1:m}=fo(f,p,t,n),x=Zt(.5-f,0),{0:y,1:v}=fo(x,(.5-x-f)*r-p,t,n);return[h,d,u,g,m,y,r*v]}function mf(i,e,t,n,s,r){let{0:o,1:a,2:l,3:c,4:u,5:h,6:d,7:f,8:p,9:g}=i.series,m=i.nome[0],{0:x,1:y}=tn(e-It(e)),v=m*m,M=v*v,w=m*r,A=w*w*v,_=A*w*M,b=_*w*M*v,I=v*s*s,T=M*I*s,L=M*v*T*s,D=M*M*L*s,O=u*(b+D),P=g*(b-D),B=-g*(b+D),H=u*(b-D);O=O+c*(_+L),P=P+p*(_-L),B=B+p*(_+L),H=H-c*(_-L),O=O+l*(A+T),P=P+f*(A-T),B=B-f*(A+T),H=H+l*(A-T),O=O+a*(w+I),P=P+d*(w-I),B=B+d*(w+I),H=H-a*(w-I),O=O+o*(1+s),P=P+h*(1-s),B=B-h*(1+s),H=H+o*(1-s),P=P*t,H=H*t;let V=1-2*(n-2*Math.floor(.5*n));return[y*O-x*P,y*P+x*O,V*(y*B-x*H),V*(y*H+x*B)]}function C0(i,e){let{0:t,1:n,2:s,3:r}=e,o=t*t+n*n,a=s*s+r*r,l=1/(o+a),c=Math.sqrt(l),u=l+l,h=(t*s+n*r)*u,d=(t*r-n*s)*u,f=(o-a)*l,p=t*c,g=n*c,m=s*c,x=r*c,y=i.toAttitude,v=i.toMomentum;return[y[0]*p+y[1]*g+y[2]*m+y[3]*x,y[4]*p+y[5]*g+y[6]*m+y[7]*x,y[8]*p+y[9]*g+y[10]*m+y[11]*x,y[12]*p+y[13]*g+y[14]*m+y[15]*x,v[0]*h+v[1]*d+v[2]*f,v[3]*h+v[4]*d+v[5]*f,v[6]*h+v[7]*d+v[8]*f]}function I0(i,e,t){let{0:n,1:s}=bn(e);if(i.full!==0)return C0(i,ff(i,[n,s,t]));let{0:r,1:o,2:a,3:l,4:c,5:u,6:h}=pf(i,[n,s,t]),d=Math.exp(l)*c,f=Math.exp(u)*h;return C0(i,mf(i,r,o,a,d,f))}var dT=1e-14;function fT(i,e){let{0:t,1:n,2:s}=i.moments,{0:r,1:o,2:a}=i.momentum,l=i.longAxis?5:4;return l=t===n||n===s?3:l,l=e.separatrix?6:l,l=e.constant?2:l,l=t===s?1:l,r===0&&o===0&&a===0?0:l}function pT(i,e,t,n,s){let{0:r,1:o,2:a}=i.moments,l=i.B[0],c=i.C[0],u=i.P[0],h=i.Q[0],d=i.G2[0],f=Ae(i.P,me(Mt(i.longAxis?-a:r,o),i.G2)),p=me(Te(f,e.G),n),g=it(s,it(t,p)),m=Math.PI*u/(Math.sqrt(l*c)*d),x=2*Math.PI*(u/(c*d))/(1+Math.sqrt(h/(c*d)));return i.A[0]===0?x:u/(l*d)<dT?m:g[0]}function Oa(i,e,t,n){return i.constant?e:i.separatrix?t:n}function P0(i,e){let t=de(Ti,2),n=Te(t,e.mean),s=me(e.precession,n),r=Te(me(n,i.V),[i.rateScale,0*i.rateScale]),o=de(Te(e.precession,i.V),i.rateScale),a=i.longAxis?-1:1,l=Math.sqrt(i.A[0]/i.B[0])*(i.rootP/Math.sqrt(i.Q[0])),c=pT(i,e,s,n,t);return{regime:fT(i,e),encircledAxis:Oa(e,-1,-1,i.order[2]),modulus:Oa(e,NaN,1,l),period:Oa(e,NaN,1/0,r[0]),precessionRate:e.constant?NaN:a*o[0],precessionPerPeriod:Oa(e,NaN,1/0,a*s[0]),solidAngle:Oa(e,NaN,NaN,c)}}function mT(i){let e=$t(me(i.B,i.Q)),t=me($t(i.C),i.rootS),n=i.B[0]>=i.A[0],s=me(n?i.Q:i.B,i.C);s=n?s:me(s,i.G2);let{0:r,2:o}=i.canonical,a=!(e[0]>0)||!(i.rootP>0)||r===0&&o===0,l=!(i.C[0]>0&&i.rootS[0]>0)&&!a,c=a||l,u=[1,0];return[{modulusRate:e,constant:a,separatrix:l},c?u:e,c?u:t,c?u:s]}function gT(i,e,t,n){let s=$t(i.G2),r=i.B[0]>=i.A[0],{0:o,1:a,2:l}=i.moments,c=i.longAxis?-1:1,u=Mt(c*(i.longAxis===r?o:l),a),h=me(r?i.A:i.P,n),d=r?de(h,-.5):de(Te(h,i.G2),.5),f=me(s,Ae(u,d)),p=r?f:Ae(f,t),g=me(s,Mt(c*o,l));return p=e.separatrix?g:p,{modulusRate:e.modulusRate,mean:t,precession:p,G:s,constant:e.constant,separatrix:e.separatrix}}function L0(i){let{0:e,1:t,2:n,3:s}=mT(i),{0:r,1:o}=Fa(t,n,s);return gT(i,e,r,o)}function N0(i,e,t){let n=de(Te(eo,e.V),e.rateScale),s=de(me(t.precession,n),.5),r=de(me(t.mean,n),2),o=de(r,.25),a=de(Te(t.modulusRate,e.V),e.rateScale),l=i?it(s,o):s,c=t.separatrix?a:i?Ae(s,o):r,{0:u,1:h}=bn(l[0]),{0:d,1:f}=bn(c[0]);return[[u,h,l[1]],[d,f,c[1]]]}var xT=11830521861667747e-287,yT=100,_T=1e-280,vT=.01,MT=5;function gf(i,e,t){let n=e[0]<i[0];return[[n?e[0]:i[0],n?e[1]:i[1],n?e[2]:i[2]],[n?i[0]:e[0],n?i[1]:e[1],n?i[2]:e[2]],n?-t:t]}function xf(i,e){return i===0?e:Math.abs(i)}function bT(i,e){let{0:t,1:n,2:s}=gf([i[0],e[0],0],[i[1],e[1],1],1),r;({0:n,1:r,2:s}=gf(n,[i[2],e[2],2],s)),{0:t,1:n,2:s}=gf(t,n,s);let o=Zt(Zt(Math.abs(t[1]),Math.abs(n[1])),Math.abs(r[1])),a=Ii(Ii(xf(t[1],o),xf(n[1],o)),xf(r[1],o)),l=sn(o)-(a<xT*o?yT:0),c=sn(r[0]);return{moments:[Je(t[0],-c),Je(n[0],-c),Je(r[0],-c)],momentum:[s*Je(t[1],-l),s*Je(n[1],-l),s*Je(r[1],-l)],order:[t[2],n[2],r[2]],parity:s,momentumScale:Je(1,l),rateScale:Je(1,l-c)}}function ST(i){let{0:e,1:t,2:n}=i.moments,{0:s,1:r,2:o}=i.momentum,a=kn(mt(t,-e),n),l=kn(mt(n,-t),e),c=kn(mt(n,-e),t),u=Ts(s),h=Ts(r),d=Ts(o),f=Ae(me(c,u),me(l,h)),p=Ae(me(a,h),me(c,d));return{A:a,B:l,C:c,P:f,Q:p,G2:Ae(Ae(u,h),d)}}function U0(i){return sn(Zt(Math.abs(i.momentum[0]),Math.abs(i.momentum[2])))}function wT(i){let e=U0(i),{0:t,2:n}=i.momentum;return[i.moments,Je(t,-e),Je(n,-e)]}function AT(i,e,t,n){let s=me(i,Ts(t)),r=it(s,me(e,Ts(n)));return[r,Math.abs(r[0])<vT*s[0]]}function ar(i,e){let t=Mt(i[0],e),n=Mt(i[1],e);return[t[0],t[1],n[0],n[1]]}function D0(i,e,t){let{0:n,1:s,2:r,3:o}=ar(i,e),a=ar([n,s],t),l=ar([r,o],t);return[ar([a[0],a[1]],t),ar([a[2],a[3]],t),ar([l[0],l[1]],t),ar([l[2],l[3]],t)]}function lr(i,e){let{0:t,1:n,2:s,3:r}=e;return{0:i,1:t}=mt(i,t),{0:i,1:n}=mt(i,n),{0:i,1:s}=mt(i,s),{0:i,1:r}=mt(i,r),[i,[t,n,s,r]]}function ET(i){let{0:e,1:t,2:n,3:s,4:r,5:o,6:a,7:l}=i,{0:c,1:u,2:h,3:d}=e,f;return{0:f,1:u}=mt(c,u),{0:f,1:h}=mt(f,h),{0:f,1:d}=mt(f,d),{0:f,1:t}=lr(f,t),{0:f,1:n}=lr(f,n),{0:f,1:s}=lr(f,s),{0:f,1:r}=lr(f,r),{0:f,1:o}=lr(f,o),{0:f,1:a}=lr(f,a),{0:f,1:l}=lr(f,l),[[u,h,d,t[0]],[t[1],t[2],t[3],n[0]],[n[1],n[2],n[3],s[0]],[s[1],s[2],s[3],r[0]],[r[1],r[2],r[3],o[0]],[o[1],o[2],o[3],a[0]],[a[1],a[2],a[3],l[0]],[l[1],l[2],l[3],f]]}function po(i,e){return i+e[0]+e[1]+e[2]+e[3]}function TT(i,e,t){let{0:n,1:s,2:r}=i,{0:o,1:a,2:l,3:c}=D0(mt(s,-n),r,e),{0:u,1:h,2:d,3:f}=D0(mt(r,-s),-n,t),p=[o,a,l,c,u,h,d,f];for(let b=0;b<MT;b++)p=ET(p);let{0:g,1:m,2:x,3:y,4:v,5:M,6:w,7:A}=p,_=g[0]+g[1]+g[2]+g[3];return _=po(po(po(po(po(po(_,m),x),y),v),M),w),_=_+A[0]+A[1]+A[2],mt(A[3],_)}function RT(i){let{0:e,1:t,2:n}=i[0];return TT(e,t,n)}function CT(i){return i[1]}function IT(i,e){let t=wT(i),{0:n,1:s}=AT(e.A,e.B,t[1],t[2]);return s?RT([t,n]):CT([t,n])}function PT(i,e,t,n,s){let r=sn(Zt(Math.abs(t),Math.abs(s)));return t=Je(t,-r),s=Je(s,-r),i>_T?Math.sqrt(i):Je(Math.sqrt(e*t*t+n*s*s),r)}function LT(i,e,t){let n=t[0]>0,s=n?e.B:e.A,r=n?e.A:e.B,o=n?e.Q:e.P,a=n?e.P:e.Q,{0:l,1:c,2:u}=i.momentum;({0:l,1:u}=[n?u:l,n?l:u]);let h=u<0?-1:1,{0:d,1:f,2:p}=i.moments,g=n?1:-1,m=Je(1,U0(i)),x=de(t,g),{0:y,1:v,2:M}=i.order;return{moments:i.moments,momentum:i.momentum,canonical:[l*h,c,u*h],A:s,B:r,C:e.C,P:o,Q:a,S:de(de(x,-m),m),rootS:de($t(x),m),rootP:PT(o[0],e.C[0],l,r[0],c),V:kn(Mt(d,f),p),G2:e.G2,longAxis:n,order:[n?M:y,v,n?y:M],parity:i.parity,halfTurn:h,momentumScale:i.momentumScale,rateScale:i.rateScale}}function F0(i,e){let t=bT(i,e),n=ST(t);return LT(t,n,IT(t,n))}var NT=38725919148493183e-137,DT=6223015277861142e-76,UT=[138.62943611198907,-33555121496085278e-31],FT=[0,0,0,0,0,0,0,0,0],OT=[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0];function Ba(i,e,t,n,s,r,o){let a=(i-e)/(i+e),l=1+a,c=Math.sqrt(1-a*(1-t)/(1+t));s=2*s/(l*(r+o));let u=Math.sqrt(1+a*(o-r)/(o+r));return[.5*(i+e),Math.sqrt(i*e),c,n*(c/l),s,u]}function O0(i,e,t,n,s){let r,o,a,l;return{0:a,1:l,2:e,3:r,4:o,5:s}=Ba(1,i,e,1,t,n,s),{0:a,1:l,2:e,3:r,4:o,5:s}=Ba(a,l,e,r,o,1,s),{0:a,1:l,2:e,3:r,4:o,5:s}=Ba(a,l,e,r,o,1,s),{0:a,1:l,2:e,3:r,4:o,5:s}=Ba(a,l,e,r,o,1,s),{0:a,1:l,2:e,3:r,4:o,5:s}=Ba(a,l,e,r,o,1,s),[r,o]}function BT(i){let e=i.A[0],t=i.B[0],n=i.C[0],s=i.Q[0],{0:r,1:o,2:a}=i.canonical,l=t*s,c=e*i.P[0]/l,u=-n*i.S[0]/l,h=Ua(c,Math.sqrt(u)),d=h*c,f=i.rootP/Math.sqrt(s),p=Math.sqrt(t),g=Math.sqrt(n),{0:m,1:x}=O0(Math.sqrt(u),a*Math.sqrt(n/s),p,p,g),y=x+Math.sqrt(f*f+x*x),v=f/y,M=e/t*h*y*y,w=v*v,A=d*d,_=M*M,b=A*d,I=A*A,T=I*I,L=w*w,D=-d*w,O=-A*M,P=I*A*L,B=T*_,H=-b*w,V=T*A*L,ee=I*_;return{rise:p*o*m,run:g*r,series:[1-(P+B),D+O,2*(P+B),D-O,2*(P-B),v*(1-(V+ee)),v*(H-M),2*v*(V+ee),v*(H+M),2*v*(V-ee)]}}function kT(i,e){return Math.atan2(i,e)*(.25/Math.PI)}function zT(i,e){return{start:[i,0],series:e,nome:[0,0,0,0,0],parity:0}}function GT(i){let e=BT(i.body);return zT(kT(e.rise,e.run),e.series)}function VT(i,e){let t=i.B[0],n=i.C[0],s=i.P[0],r=i.Q[0],{0:o,1:a,2:l}=i.canonical,c=t*r,u=e.separatrix?1:Math.sqrt(i.A[0]*s/c),h=e.separatrix?0:-n*i.S[0]/c,d=Math.sqrt(n),f=Math.sqrt(s/t)/e.G[0],p=Math.abs(Math.sqrt(t)*a),g=d*Math.abs(o),m=d*l*Math.sqrt(s/r),x=g+m<NT*p,{0:y,1:v}=O0(u,f,x?DT*p:p,g,m);return{nome:h*Ua(h,u),tangent:Math.sqrt(r/s)*y,sinh:v,huge:x}}function HT(i){let e=Math.log(2*i);return[e,.5*Math.exp(e)]}function WT(i){let e=Math.asinh(i);return[e,Math.sinh(e)]}function qT(i){let{0:e,1:t}=i.huge?HT(i.sinh):WT(i.sinh);return{x:e,sinh:t,y:Math.atan(i.tangent)}}function XT(i,e,t,n){let{0:s,1:r}=i.canonical,o=t.huge?n.sinh:Math.sqrt(1+n.sinh*n.sinh),a=Ei(n.x,(t.sinh-n.sinh)/o);a=t.huge?Ae(a,UT):a,a=de(a,r<0==s<0?1:-1);let l=YT(e.modulusRate,e.mean,t.nome);l=e.separatrix?[1,0]:l;let{0:c,1:u}=bn(l[0]),h=e.separatrix?0:1;return{start:Te(a,l),series:ZT(n.y),nome:[Math.sqrt(t.nome),c,u+l[1],h*n.y*(.5/Math.PI),h],parity:s<0?1:0}}function $T(i){let e=VT(i.body,i.rates);return XT(i.body,i.rates,e,qT(e))}function YT(i,e,t){return Iu(Te(me(i,Ti),e),t)}function ZT(i){let e=(.5*i-.25*Math.PI)*(.5/Math.PI),{0:t,1:n}=tn(e),{0:s,1:r}=tn(3*e),{0:o,1:a}=tn(5*e-It(5*e)),{0:l,1:c}=tn(7*e-It(7*e)),{0:u,1:h}=tn(9*e-It(9*e));return[n,r,a,c,h,t,s,o,l,u]}function _f(i,e,t,n,s){let{0:r,1:o,2:a,3:l}=i;return[r*e-o*t-a*n-l*s,r*t+o*e+a*s-l*n,r*n-o*s+a*e+l*t,r*s+o*n-a*t+l*e]}function yf(i,e,t,n,s){return e[0]===i?t:e[1]===i?n:s}function Pu(i,e,t,n,s,r){return _f(i,t,yf(0,e,n,s,r),yf(1,e,n,s,r),yf(2,e,n,s,r))}function vf(i){let{0:e,1:t,2:n}=i.order,s=i.parity,r=i.parity*i.halfTurn;return[[e===0?r:0,t===0?s:0,n===0?r:0],[e===1?r:0,t===1?s:0,n===1?r:0],[e===2?r:0,t===2?s:0,n===2?r:0]]}function jT(i,e,t,n){let{0:s,1:r,2:o,3:a}=n,l=Math.sqrt(s*s+r*r+(o*o+a*a));s=s/l,r=r/l,o=o/l,a=a/l;let c=i.longAxis?-i.parity:i.parity,u=i.order,h=c*i.halfTurn,d=Pu(t,u,s,-h*a,c*o,-h*r),f=Pu(t,u,r,h*o,c*a,h*s),p=Pu(t,u,o,-h*r,-c*s,h*a),g=Pu(t,u,a,h*s,-c*r,-h*o),m=e*i.momentumScale,{0:x,1:y,2:v}=vf(i);return[[d[0],f[0],p[0],g[0],d[1],f[1],p[1],g[1],d[2],f[2],p[2],g[2],d[3],f[3],p[3],g[3]],[m*x[0],m*x[1],m*x[2],m*y[0],m*y[1],m*y[2],m*v[0],m*v[1],m*v[2]]]}function KT(i){return i.A[0]*i.P[0]<=-i.C[0]*i.S[0]}function JT(i){let e=0*i.start[0];return ff(i,[e,e,e])}function QT(i){let e=0*i.start[0],{0:t,1:n,2:s,3:r,4:o,5:a,6:l}=pf(i,[e,e,e]);return mf(i,t,n,s,Math.exp(r)*o,Math.exp(a)*l)}function e2(i){let e=i.body,t=i.rates,n=KT(e)&&!t.separatrix,{0:s,1:r}=N0(n,e,t),o=n?GT(i):$T(i),a=n?1:0,l={full:a,first:s,second:r,start:o.start,series:o.series,nome:o.nome,parity:o.parity,toAttitude:OT,toMomentum:FT},c=n?JT(l):QT(l),{0:u,1:h}=jT(e,t.G[0],i.attitude,c);return{full:a,first:s,second:r,start:o.start,series:o.series,nome:o.nome,parity:o.parity,toAttitude:u,toMomentum:h}}function t2(i){let{0:e,1:t,2:n}=i.moments,{0:s,1:r,2:o}=i.momentum,a=0*i.rootP,l=Te([s,a],[e,a]),c=Te([r,a],[t,a]),u=Te([o,a],[n,a]),h=$t(Ae(Ae(Ln(l),Ln(c)),Ln(u))),d=de(de(me(h,eo),.5),i.rateScale),{0:f,1:p}=bn(d[0]);return[f,p,d[1]]}function n2(i,e){let{0:t,1:n,2:s}=i,{0:r,1:o,2:a}=e,l=Zt(Zt(Math.abs(r),Math.abs(o)),Math.abs(a));l=l>0?l:1;let c=Ii(Ii(t,n),s);r=r/l*(c/t),o=o/l*(c/n),a=a/l*(c/s);let u=Math.sqrt(r*r+o*o+a*a);return u=u>0?u:1,[r/u,o/u,a/u]}function i2(i){let e=0*i.body.rootP,t=e+1,{0:n,1:s,2:r}=n2(i.moments,i.momentum),o=_f(i.attitude,1,e,e,e),a=_f(i.attitude,0,n,s,r),{0:l,1:c,2:u}=i.momentum;return{full:t,first:t2(i.body),second:[e,e,e],start:[e,e],series:[t,e,e,e,e,e,e,e,e,e],nome:[e,e,e,e,e],parity:e,toAttitude:[o[0],a[0],e,e,o[1],a[1],e,e,o[2],a[2],e,e,o[3],a[3],e,e],toMomentum:[e,e,l,e,e,c,e,e,u]}}function B0(i){return i.rates.constant?i2(i):e2(i)}var s2=["rest","spherical","permanent","symmetric","short-axis","long-axis","separatrix"],pi=class{constructor({moments:e,momentum:t,attitude:n=[1,0,0,0],epoch:s=0}){this.moments=to(e),this.momentumAtEpoch=Sn("momentum",t,3,"kg m\xB2/s"),this.attitudeAtEpoch=io(no(n)),this.epoch=At("epoch",s,"seconds");let r={moments:this.moments,momentum:this.momentumAtEpoch,attitude:this.attitudeAtEpoch},o=F0(r.moments,r.momentum),a=L0(o);this._fastest=Math.max(...r.momentum.map((d,f)=>Math.abs(d/r.moments[f]))),this._motion=B0({...r,body:o,rates:a});let{first:l,second:c,toAttitude:u,toMomentum:h}=this._motion;gu([this._fastest,...l,...c,...u,...h]),this._curve={body:o,rates:a},this.energy=.5*r.momentum.reduce((d,f,p)=>d+f/r.moments[p]*f,0),this.momentumNorm=Math.hypot(...r.momentum),Object.assign(this,r2(o,a))}state(e){let[t,n]=mu(e,this.epoch,this._fastest);return xu(I0(this._motion,t,n))}angularVelocity(e){let t=this.state(e).momentum;return[t[0]/this.moments[0],t[1]/this.moments[1],t[2]/this.moments[2]]}along(e){let{body:t,rates:n}=this._curve,s=this.momentumAtEpoch;if(n.constant)return Array.from({length:e},()=>[...s]);let[r,o,a,l,c]=[t.A,t.B,t.C,t.P,t.Q].map(v=>v[0]),u=o*c,[h,d]=n.separatrix?[1,0]:[r*l/u,-a*t.S[0]/u],[f,p]=t.canonical,g=vf(t),m=t.rootP,x=Math.atan2(Math.sqrt(o)*p,Math.sqrt(a)*f),y=n.separatrix&&f<0?-1:1;return Array.from({length:e},(v,M)=>{let w=n.separatrix?Math.PI*(M/Math.max(e-1,1)-.5):x+2*Math.PI*M/e,A=y*Math.cos(w),_=y*Math.sin(w),b=[m/Math.sqrt(a)*A,m/Math.sqrt(o)*_,Math.sqrt(c/a)*Math.sqrt(d+h*A*A)];return g.map(I=>t.momentumScale*(I[0]*b[0]+I[1]*b[1]+I[2]*b[2]))})}};function r2(i,e){let t=P0(i,e),n=s2[t.regime];return{regime:n,encircledAxis:t.encircledAxis<0?null:t.encircledAxis,modulus:zn(t.modulus),period:zn(t.period),precessionRate:zn(t.precessionRate),precessionPerPeriod:zn(t.precessionPerPeriod),flipInterval:n==="symmetric"?null:zn(.5*t.period),solidAngle:zn(t.solidAngle)}}function Fs(i,e){let{0:t,1:n,2:s,3:r}=i,{0:o,1:a,2:l,3:c}=e;return r*c+s*l+n*a+t*o}function mo(i,e){let{0:t,1:n,2:s,3:r}=i,{0:o,1:a,2:l,3:c}=e;return r*(7*c)+s*(5*l)+n*(3*a)+t*o}function k0(i,e){let{0:t,1:n,2:s,3:r}=i,{0:o,1:a,2:l,3:c}=e;return r*(8*c)+s*(6*l)+n*(4*a)+t*(2*o)}function Lu(i,e){let{0:t,1:n}=Ki(i,e);return t+n}function Mf(i,e){let{0:t,1:n}=i.signs,{0:s,1:r}=Ki(i.third,e),o=s+(r+i.start[0]),{0:a,1:l}=tn(o-It(o)),c=1-2*a*a,u=2*a*l,h=l*c-a*u,d=a*c+l*u,f=h*c-d*u,p=d*c+h*u,g=f*c-p*u,m=p*c+f*u,x=[l,h,f,g],y=[a,d,p,m];return[Fs(i.aSum,y),-t*Fs(i.aGap,x),Fs(i.bSum,x),n*Fs(i.bGap,y),mo(i.aSum,x),t*mo(i.aGap,y),-mo(i.bSum,y),n*mo(i.bGap,x),Lu(i.first,e),Lu(i.second,e)]}function bf(i,e){let{1:t,2:n,3:s,4:r,5:o}=i.nome,{0:a,1:l}=i.signs,{0:c,1:u,2:h}=Cu(i.third,i.start,o,e),d=c<0?-1:1,f=c*d,p=u*d,{0:g,1:m}=fo(f,p,t,n),x=Zt(.5-f,0),{0:y,1:v}=fo(x,(.5-x-f)*o-p,t,n),M=.5*(h-2*Math.floor(.5*h)),w=c+u,A=Lu(i.first,e)+a*w*s,_=Lu(i.second,e)+l*w*r;return A=A-It(A)+M,_=_-It(_)+M,[d,A,_,g,m,y,o*v]}function Sf(i,e,t,n,s,r){let o=i.nome[0],{0:a,1:l}=i.signs,c=s*s,u=r*r,h=c*c,d=c*h,f=d*h,p=f*h,g=o*o,m=g*o,x=o*u,y=g*u,v=m*u,M=o*c,w=g*c,A=m*c,_=g*g*c,b=y*y,I=v*v,T=x*x,L=b*y,D=I*I,O=w*w,P=A*A*A,B=_*_*(_*_);I=I*v;let H=[1+c,x*(1+d),b*(1+f),I*(1+p)],V=[1-c,x*(1-d),b*(1-f),I*(1-p)],ee=[u+M,T+O,L+P,D+B],X=[u-M,T-O,L-P,D-B],j=2*s;return[Fs(i.aSum,H),a*e*Fs(i.aGap,V),j*(i.constant+Fs(i.bSum,ee)),-l*e*j*Fs(i.bGap,X),e*mo(i.aSum,V),a*mo(i.aGap,H),e*j*k0(i.bSum,X),-l*j*k0(i.bGap,ee),t,n]}function z0(i,e){let{0:t,1:n,2:s,3:r,4:o,5:a,6:l,7:c,8:u,9:h}=e,{0:d,1:f}=i.rates,{0:p,1:g,2:m,3:x}=i.phases,y=1/(t*t+n*n+(s*s+r*r)),v=Math.sqrt(y),{0:M,1:w}=tn(u-It(u)),A=w*p-M*g,_=M*p+w*g;({0:M,1:w}=tn(h-It(h)));let b=w*m-M*x,I=M*m+w*x,T=(t*A-n*_)*v,L=(t*_+n*A)*v,D=(s*b-r*I)*v,O=(s*I+r*b)*v,P=t*l+n*c-(s*o+r*a),B=t*c-n*l-(r*o-s*a),H=n*s-t*r,V=t*s+n*r,ee=(d*P+f*H)*y,X=(d*B+f*V)*y,j=b*A+I*_,te=I*A-b*_,ve=i.reversed,Pe=ve<0,{0:Y,1:ge}=Pe?[D,O]:[T,L],Me;return{0:y,1:Me}=Pe?[T,L]:[D,O],[Y,ve*y,ve*Me,ge,ee*j-X*te,ve*(ee*te+X*j),i.axial]}function G0(i,e,t){let{0:n,1:s}=bn(e);if(i.full!==0)return z0(i,Mf(i,[n,s,t]));let{0:r,1:o,2:a,3:l,4:c,5:u,6:h}=bf(i,[n,s,t]),d=Math.exp(l)*c,f=Math.exp(u)*h;return z0(i,Sf(i,r,o,a,d,f))}var o2=-400,pn=[1,0],Os=[0,0];function Nu(i){return i.s0[0]<i.t0[0]}function ka(i){return i.lift>0&&Nu(i)&&i.D[0]>0}function V0(i,e,t,n,s,r,o,a,l,c,u,h){let d=it(de(kn(a,i),2),me(e,me(n,s)));d=it(d,de(me(r,o),2));let f=it(it(de(me(e,r),2),o),Ts(i));return u=me(u,t),h=me(h,t),[d,[f,me(e,d),me(Ln(e),l)],[[-u[0],-u[1]],de(h,-2),me(c,t)]]}function Ji(i,e){let t=i[0]===0;return t?i:Te(i,t?pn:e)}function H0(i,e){let t=sn(i[0]),n=e[0]===0||sn(e[0])<2*t,s=i[0]!==0&&t<o2&&n?-t:0,r=Je(1,s),o=de(de(e,r),r);return de($t(Ae(Ln(de(i,r)),de(o,4))),Je(1,-s))}function W0(i,e,t){let n=i[0]>=0,s=de(Ae(e,n?i:[-i[0],-i[1]]),.5),r=s[0]>0?Ji(t,s):Os;return[n?s:r,n?r:s]}function a2(i,e,t,n,s,r){let o=Ji(t,r),a=Ji(Ae(s,me(i,o)),r),l=H0(a,o),{0:c,1:u}=W0(a,l,o),h=Ae(e,u),d=it(e,c),f=it(r,me(i,e)),p=f[0]>=me(i,d)[0],g=Ji(n,me(h,p?f:d));return d=p?g:d,f=p?f:g,[u,c,l,h,d,Ae(r,me(i,u)),it(r,me(i,c)),r,f]}function l2(i,e,t,n,s,r){let o=me(i,r),a=Ji(n,o),l=Te(Ae(de(s,-2),Ji(n,r)),o),c=H0(l,a),{0:u,1:h}=W0(l,c,a),d=me(i,h),f=Ae(me(i,e),d),p=it(e,u),g=it(r,e),m=p[0]>=g[0],x=Ji(Ji(t,f),m?p:g);return p=m?p:x,g=m?x:g,[g,p,it(r,u),r,u,me(i,Ae(r,h)),me(i,c),f,d]}function q0(i,e,t,n,s,r,o,a,l,c,u){let h=a2(t,s,o,a,u,e),d=l2(n,s,o,a,c,e),f=i?h[1]:d[1],p=i?h[7]:d[7],g=Ae(r,f),m=Ae(p,me(t,r));return{fromLower:i?h[0]:d[0],fromUpper:f,d:i?h[2]:d[2],s1:i?h[3]:d[3],s2:i?h[4]:d[4],t1:Ji(Ln(l),me(g,m)),t2:g,A:i?h[5]:d[5],B:i?h[6]:d[6],Y:p,ZMinus:i?h[8]:d[8],ZPlus:m}}var X0=40,c2=.01,u2=.002;function $0(i,e){let t=-i-e,n=i*e-t*t,s=i*e*t,r=n*n*(1/24-n*(5/208))-n*s*(3/44);return r=r+s*(3/104*s+.0625*n*n),r+s*(1/14)-.1*n}function Y0(i,e,t){let n=(i+e+t)/3;return Zt(Zt(Math.abs(n-i),Math.abs(n-e)),Math.abs(n-t))/n}function h2(i){let{0:e,1:t,2:n}=i,s=Math.sqrt(e),r=Math.sqrt(t),o=Math.sqrt(n),a=s*r+r*o+o*s;return[.25*(e+a),.25*(t+a),.25*(n+a)]}function Z0(i){return Y0(i[0],i[1],i[2])<=c2}function d2(i){let{0:e,1:t,2:n}=i,s=(e+t+n)/3;return Z0(i)?(1+$0(1-e/s,1-t/s))/Math.sqrt(s):NaN}function f2(i){let{0:e,1:t,2:n}=i,s=$t(e),r=$t(t),o=Rs(n),a=Ae(me(s,Ae(r,o)),me(r,o));return[de(Ae(e,a),.25),de(Ae(t,a),.25),de(Ae(n,a),.25)]}function j0(i){return Y0(i[0][0],i[1][0],i[2][0])<=u2}function p2(i){let{0:e,1:t,2:n}=i,s=pn,r=Te(Ae(Ae(e,t),n),[3,0]),o=$0(1-Te(e,r)[0],1-Te(t,r)[0]);return j0(i)?Te(Ae(s,[o,0*o]),Rs(r)):[NaN,NaN]}function m2(i,e){let t=e.d[0],n=e.t2[0];return[t/n,t*e.ZPlus[0]/(e.A[0]*n),e.t1[0]/n]}function g2(i,e){let t=e.d[0],n=e.s1[0],s=e.B[0];return[t*e.ZMinus[0]/(n*s),t/n,e.s2[0]*e.A[0]/(n*s)]}function x2(i,e){let t=i.G[0],n=e.ZPlus[0];return[t*e.t1[0]/n,t*e.t2[0]/n,e.A[0]/n]}function y2(i,e){let t=i.G[0],n=e.B[0];return[t*e.s2[0]/n,t*e.s1[0]/e.A[0],e.ZMinus[0]/n]}function _2(i){return[Te(i.fromUpper,i.d),Te(i.Y,i.A),Te(i.fromLower,i.d)]}function Du(i,e){let{0:t,1:n,2:s}=e,r=t+n,o=(i?0:r)>0;o=o&&r<1/0;let l=[o?t:1,o?n:1,1+0*t];for(let c=0;c<X0&&!Z0(l);c++)l=h2(l);return Math.sqrt(s)*d2(l)}function v2(i,e){let{0:t,1:n,2:s}=e,r=t[0]+n[0],o=pn,a=(i?0:r)>0;a=a&&r<1/0;let c=[a?t:o,a?n:o,o];for(let u=0;u<X0&&!j0(c);u++)c=f2(c);return me($t(s),p2(c))}function K0(i,e,t){let n=t.permanent||t.steady,s=t.separatrix,r=e.d[0],o=Du(n,m2(i,e)),a=Du(n,g2(i,e));o=s?Math.atan2(Math.sqrt(e.t1[0]),Math.sqrt(r)):o,a=s||e.s2[0]===0?0:a;let l=t.steady?1/0:0,c=v2(n,_2(e));return{vAlpha:n?l:o,vBeta:n?l:a,wAlpha:Du(n,x2(i,e)),wBeta:Du(n,y2(i,e)),x0:n&&r<=0?Os:c}}function J0(i,e){let t=[1,0];return i[0]<e[0]?it(t,i)[0]:it(e,t)[0]}function M2(i,e){let t=i.momentum[2],n=i.c[0],s=i.cPlus[0],r=i.lean[0],o=t<0?-r:r,a=n*t<0&&s*t>0,l=a&&o>0?8:6;return l=a&&o===0?7:l,l=t===0&&n===0?5:l,l=e.steady?3:l,l=e.separatrix?9:l,l=e.permanent?i.s0[0]===0?1:2:l,l=i.G[0]===0?4:l,t===0&&e.permanent?0:l}function wf(i,e,t,n){return i.permanent?e:i.separatrix?t:n}function Q0(i,e,t){let n=J0(e.s1,e.t1),s=J0(e.s2,e.t2);n=t.permanent?i.u0[0]:n,s=t.permanent?i.u0[0]:s;let r=Ti,o=Ae(Te(t.alpha,t.nutation),[t.signAlpha,0*t.signAlpha]),a=Ae(Te(t.beta,t.nutation),[t.signBeta,0*t.signBeta]),l=Te(t.spin,t.nutation),c=me(r,Ae(o,a))[0],u=me(r,Ae(it(o,a),l))[0],h=Te(kn(r,i.moments[0]),de(t.nutation,i.rateScale))[0];return u=(i.reversed?-1:1)*u+0,{regime:M2(i,t),lowest:i.reversed?-s:n,highest:i.reversed?-n:s,period:wf(t,NaN,1/0,h),precessionPerPeriod:wf(t,NaN,NaN,c),spinPerPeriod:wf(t,NaN,NaN,u)}}function b2(i,e,t,n,s){return i?t:Te(me(e,s),i?pn:n)}function S2(i,e,t,n,s,r,o){let a=Te(me(r,n),i?pn:o);return i?e[0]===0?t:s:a}function ex(i,e,t,n,s,r,o,a,l){let c=e[0]===0,u=Te(i?me(e,t):e,c?pn:i?n:s),h=it(pn,de(me(Te(o,r),l),.5));return i?de(me(u,l),.25):it(me(de(u,.5),h),a)}function w2(i,e,t){return Te(kn(mt(i,-e),t),[e,0])}function tx(i,e,t){let n=Te(eo,[e,0]);return me(i,de(n,t))}function nx(i,e,t){return Te(de(i,t),kn(Ti,e))}function ix(i,e,t){let n=Te(de(me(i,Ti),.5),e);return[n,Iu(de(n,2),t)]}function sx(i){return i.ZPlus[0]<=2*i.A[0]}function rx(i,e){return me(i.G,e.s2)[0]<=e.ZMinus[0]}function A2(i,e){let t=i.momentum[2],n=i.s0[0]===0||i.t0[0]===0,s=i.w2[0]===0&&(n||i.G[0]===0&&t===0),r=!(e.B[0]>0)&&!s,o=s||r,a=pn,l=b2(sx(e),e.A,e.ZPlus,e.t1,e.t2),c=rx(i,e),u=S2(c,i.c,e.A,e.B,e.ZMinus,e.s1,e.s2);return{rootA:o?a:$t(e.A),rootB:o?a:$t(e.B),alpha:o?a:l,beta:o?a:u,permanent:s,separatrix:r}}function E2(i,e,t,n,s,r){let o=de(n,.5),a=t.separatrix,l=i.cPlus[0]>=0?1:-1,c=i.c[0]>=0?1:-1,u=de(i.cPlus,l),h=de(i.c,c),d=rx(i,e),f=ex(sx(e),u,i.G,e.ZPlus,e.t1,e.t2,e.d,o,s),p=ex(d,h,i.G,e.ZMinus,e.s2,e.s1,e.d,o,r);f=de(a?de(u,.25):f,l),p=de(a?Os:p,d?-c:c);let g=!(e.d[0]>0||t.permanent||a);return{halfRoot:de($t(e.A),.5),nutation:a?Os:o,alpha:f,beta:p,signAlpha:l,signBeta:c,spin:w2(i.moments[0],i.moments[1],i.momentum[2]),permanent:t.permanent,separatrix:a,steady:g}}function Af(i){return kn(Zg,ka(i)?i.lift:0)}function T2(i,e){let t=e.halfRoot,n=de(i.cPlus,.25),s=pn,r=Ti,o=ka(i),a=de(Te(me(Af(i),e.nutation),me(r,t)),2),l=Te(s,Ae(s,a)),c=Ae(n,me(it(e.alpha,n),l));return{halfRoot:t,nutation:o?me(e.nutation,l):e.nutation,alpha:o?c:e.alpha,beta:o?me(e.beta,l):e.beta,signAlpha:e.signAlpha,signBeta:e.signBeta,spin:e.spin,permanent:e.permanent,separatrix:e.separatrix,steady:e.steady}}function ox(i,e){let t=A2(i,e),{0:n,1:s}=Fa(t.rootA,t.rootB,t.alpha),{1:r}=Fa(t.rootA,t.rootB,t.beta);return T2(i,E2(i,e,t,n,s,r))}function ax(i,e){let t=de(e.spin,.5),{0:n,1:s}=i.moments,r=Te(Mt(.5*i.momentum[2],n),[s,0]),o=e.permanent?r:Ae(e.alpha,t),a=e.permanent?[-r[0],-r[1]]:it(e.beta,t);return[tx(o,n,i.rateScale),tx(a,n,i.rateScale)]}var lx=[0,0,0,0];function R2(i,e){return i.G[0]*e.d[0]<=e.B[0]}function dx(i,e,t,n){let s=i.G[0]*e.d[0]/e.A[0],r=t.separatrix?0:e.B[0]/e.A[0],o=t.permanent||R2(i,e)&&!t.separatrix,a=t.permanent?0:o?s:r,l=a*Ua(a,Math.sqrt(1-a)),c=l*l*(l*l),u=1+2*(l+c+c*c*l),h=1/(u*u),d=de(Ae(n.x0,Af(i)),i.p[0]>=0?1:-1);return{full:o,q:l,theta3:u,yAlpha:n.vAlpha*h,yBeta:n.vBeta*h,wAlpha:n.wAlpha*h,wBeta:n.wBeta*h,x0:d}}function cx(i,e,t,n,s){let r=t*n,o=t*t*n,a=t*t*t*n;o=o*o,a=a*a*a;let l=e*e*e,c=l*e*e,u=l*l*e;return i=i/(a*(1+u)+o*(1+c)+r*(1+l)+(1+e)),r=s*i*r,o=i*o,a=s*i*a,[[i*(1+e),r*(1+l),o*(1+c),a*(1+u)],[i*(1-e),r*(1-l),o*(1-c),a*(1-u)]]}function C2(i,e,t,n){let s=t*t*(t*t);return[i*n,e*(1-2*(t-s+s*s*t))]}function ux(i){let{0:e,1:t}=tn(i*(.5/Math.PI)),n=2*e*t,s=1-2*e*e;return[[t,s,s*t-n*e,1-2*n*n],[e,n,n*t+s*e,2*n*s]]}function I2(i,e,t,n,s,r){let o=t*t,a=o*o,l=o*o*o,c=l*o*t,{0:u,1:h}=ux(s),d=1-2*(t*u[1]-a*u[3]+c*(2*u[2]*u[2]-1)),f=i*n/d,p=u[3]*u[0]-h[3]*h[0],g=h[3]*u[0]+u[3]*h[0],m=u[3]*u[2]-h[3]*h[2],x=h[3]*u[2]+u[3]*h[2],y=[f*h[0],-f*h[2],f*g,-f*x],v=[f*u[0],-f*u[2],f*p,-f*m];return{0:u,1:h}=ux(2*r),d=1-2*(t*u[0]-a*u[1]+c*u[2]),f=e*(1+o+l+l*l)/d,[y,v,[-f*u[0],f*u[1],-f*u[2],f*u[3]],[-f*h[0],f*h[1],-f*h[2],f*h[3]],f]}function Tf(i,e,t){let n=Je(1,-(ka(i)?0:i.lift)),s=Nu(i),r=Math.sqrt(.5*e[0]),o=Math.sqrt(.5*t[0]);return[r*(s?1:n),o*(s?n:1)]}function P2(i){return[Math.exp(-2*i.wAlpha),Math.exp(-2*i.yAlpha),Math.exp(-2*i.wBeta),Math.exp(-2*i.yBeta)]}function L2(i,e,t,n){let{0:s,1:r}=Tf(i,e.t2,e.s1),{0:o,1:a}=C2(s,r,t.q,t.theta3),l=t.q>0,{0:c,1:u}=cx(o,n[1],t.q,l?n[0]:0,-1),{0:h,1:d}=cx(a,n[3],t.q,l?n[2]:0,1);return[c,u,h,d,0]}function N2(i){return L2(i.top,i.points,i.at,P2(i.at))}function D2(i){let{0:e,1:t}=Tf(i.top,i.top.t0,i.top.s0);return[[e,0,0,0],lx,lx,[t,0,0,0],0]}function U2(i){return i.rates.permanent?D2(i):N2(i)}function F2(i,e,t){let{0:n,1:s}=Tf(i,e.t2,e.s1);return I2(n,s,t.q,t.theta3,t.yAlpha,t.yBeta)}function O2(i){return F2(i.top,i.points,i.at)}function hx(i,e,t,n,s,r,o,a,l,c,u,h){i=i/l,e=e/l;let d=u*(t/l-i*c)-r*e,f=u*(n/l-e*c)+r*i,{0:p,1:g}=o,{0:m,1:x}=a,y=i*p+e*g+(d*m+f*x)/h,v=i*g-e*p+(d*x-f*m)/h,{0:M,1:w}=tn(s-It(s));({0:y,1:v}=[y*w+v*M,v*w-y*M]);let A=Math.sqrt(y*y+v*v),_=A>0,b=_?A:1;return[_?y/b:1,_?v/b:0]}function B2(i,e,t,n,s,r,o){let{0:a,1:l,2:c}=t,u=Rs(e),h=Te([i[0],0],u)[0],d=Te([i[1],0],u)[0],f=Te([i[2],0],u)[0],p=Te([i[3],0],u)[0],g=[.5*(-c*p-(a*d+l*f)),.5*(c*h-(a*f-l*d))],m=[.5*(a*h-l*p+c*f),.5*(a*p+l*h-c*d)],{0:x,1:y,2:v,3:M,4:w,5:A,6:_,7:b,8:I,9:T}=s,L=x*x+y*y+(v*v+M*M),D=Math.sqrt(L),O=(x*w+y*A+(v*_+M*b))/L,{0:P,1:B}=hx(x,y,w,A,I,r[0],[h,p],g,D,O,o,n),{0:H,1:V}=hx(v,M,_,b,T,r[1],[d,f],m,D,O,o,n);return[P,B,H,V]}function k2(i,e,t){let{0:n,1:s,2:r,3:o,4:a,5:l,6:c,7:u,8:h,9:d}=t,f=Je(1,i.lift),p=Nu(i),g=p?1:f,m=p?f:1,{0:x,1:y,2:v}=i.momentum,M=x*x+y*y+(v*v+i.G[0]),w=[n*g,s*g,r*m,o*m,a*g,l*g,c*m,u*m,h,d];return B2(i.quaternion,i.size,i.momentum,M>0?M:1,w,e.linear,e.turn)}function Ef(i){let{0:e,1:t}=bn(i[0]);return[e,t,i[1]]}function z2(i,e,t){let{0:n}=i.moments,s=e.permanent,r=e.separatrix,o=t.full,{0:a,1:l}=ax(i,e),c=nx(e.nutation,n,i.rateScale),u=Te(de(e.halfRoot,i.rateScale),[n,0]),h=s?Os:o?de(c,.5):r?u:c,{0:d,1:f}=ix(e.halfRoot,e.nutation,t.q),p=de(Te(t.x0,d),.5),g=o?de(p,.5):r?t.x0:p;g=s?[.25,0]:g,f=r?pn:f;let{0:m,1:x}=bn(f[0]),y=o||r?0:t.yAlpha,v=o||r?0:t.yBeta,M=e.nutation[0]*(2/Math.PI),w=e.signAlpha,A=e.signBeta,_=o?e.nutation[0]:e.halfRoot[0]/(t.theta3*t.theta3),b=s?0:e.alpha[0]+w*y*M,I=s?0:e.beta[0]+A*v*M;_=s?0:_;let T=i.momentumScale;return{rates:[Ef(a),Ef(l),Ef(h),g],places:[[t.q,m,x+f[1],y/Math.PI,v/Math.PI,r?0:1],[s?1:w,s?1:A],[2*_*T,2*(b+I)*T]],linear:[b,I],turn:_}}function fx(i,e,t,n){let{0:s,1:r,2:o,3:a}=e.rates,{0:l,1:c,2:u}=e.places,{0:h,1:d,2:f,3:p,4:g}=t;return{full:i.at.full?1:0,first:s,second:r,third:o,start:a,aSum:h,aGap:d,bSum:f,bGap:p,constant:g,nome:l,signs:c,rates:u,phases:n,axial:i.axial,reversed:i.top.reversed?-1:1}}function G2(i){let e=z2(i.top,i.rates,i.at),t=i.at.full?U2(i):O2(i);return[fx(i,e,t,[1,0,1,0]),e]}function V2(i){let e=0*i.start[0];return Mf(i,[e,e,e])}function H2(i){let e=0*i.start[0],{0:t,1:n,2:s,3:r,4:o,5:a,6:l}=bf(i,[e,e,e]);return Sf(i,t,n,s,Math.exp(r)*o,Math.exp(a)*l)}function W2(i,e,t){let n=i.at.full?V2(e):H2(e),s=[e.aSum,e.aGap,e.bSum,e.bGap,e.constant];return fx(i,t,s,k2(i.top,t,n))}function px(i){let{0:e,1:t}=G2(i);return W2(i,e,t)}var q2=5,X2=.8660254,$2=.1642,Y2=-.0302;function mx(i,e,t){let n=i/3,s=e-i*n,r=2*(n*n)*n-n*e+t,o=Math.sqrt(Zt(-s/3,0)),a=o>0?-.5*r/(o*o*o):1,l=Ii(Zt(a,0),1),c=X2+l*($2+l*Y2);return c=(8*c*c*c+l)/(12*c*c-3),c=(8*c*c*c+l)/(12*c*c-3),[2*o*c-n,a]}function Z2(i){let{0:e,1:t}=i,{0:n,1:s,2:r}=t,o=Ae(me(Ae(me(Ae(e,n),e),s),e),r),a=Ae(me(Ae(Ae(de(e,2),e),de(n,2)),e),s),l=Te(o,a);return[l[0]-l[0]===0?it(e,l):e,t]}function gx(i){let e=!(i.G[0]>0),t=e?pn:i.G,n=Ln(i.p),s=Ln(i.c),{0:r,1:o,2:a}=V0(i.momentum[2],i.G,Te(pn,t),i.s0,i.t0,i.u0,i.w2,i.twist,n,s,i.D,i.F),{0:l,1:c}=mx(o[0][0],o[1][0],o[2][0]),{0:u}=mx(a[0][0],a[1][0],a[2][0]),h=c>=0||e,d=[h?o[0]:a[0],h?o[1]:a[1],h?o[2]:a[2]],f=[[h?l:u,0],d];for(let g=0;g<q2;g++)f=Z2(f);let{0:p}=f;return q0(h,p,i.G,t,i.s0,i.t0,n,s,i.cPlus,i.F,r)}var j2=(i,e)=>i.flatMap(t=>Mt(t,e)),xx=(i,e)=>e.flatMap(t=>j2(i,t));function yx(i){let e=[],t=i[0];for(let n=1;n<i.length;n++){let[s,r]=mt(t,i[n]);t=s,e.push(r)}return e.push(t),e}function Uu(i,e=5){let t=i;for(let s=0;s<e;s++)t=yx(t);let n=t[0];for(let s=1;s<t.length-1;s++)n+=t[s];return mt(t[t.length-1],n)}function Fu(i,e=4){if(i.length<=e)return i;let t=i;for(let n=0;n<=e;n++)t=yx(t);return t.slice(-e)}var[K2,J2]=[-200,-150];function _x(i,e,t,n){let s=e<0,r=s?[-n[1],n[0],n[3],-n[2]]:[...n],[o,a,l,c]=r,u=s?-1:1,h=sn(i[0]),d=eR(i[0],Math.abs(e),t),[f,p]=[i[0],i[2]].map(P=>Je(P,-h)),g=[t[0],u*t[1],u*t[2]],m=g.map(P=>Je(P,-d)),x=Je(Je(Math.abs(e),h-d),-d),y=de(Mt(x,f),2),v=Fu([...Ou(a,l),...Ou(o,c)]),{below:M,lift:w,kept:A}=Q2(y,m,r),b=[...[0,1].map(P=>A*Je(g[P],w-d)),m[2]],[I,T]=M?[0,w]:[w,0],[L,D]=[a,l].map(P=>A*Je(P,I)),O=[Je(o,T),L,D,Je(c,T)];return{moments:[f,p],momentum:b,quaternion:O,reversed:s,lift:w,momentumScale:Je(1,d),rateScale:Je(1,d-h),...tR(y,v,b,O)}}var Ou=(i,e)=>Fu([...Mt(i,i),...Mt(e,e)]);function Q2(i,[e,t,n],[s,r,o,a]){let l=(y,v)=>Math.max(Math.abs(y),Math.abs(v)),[c,u]=[l(s,a),l(r,o)],h=c<u,d=Math.max(Math.min(c,u),l(e,t)),f=sn(d),[p,g]=[de(i,2),Mt(n,n)],m=!h&&p[0]===g[0]&&p[1]===g[1],x=d>0&&f<K2&&i[0]>0;return{below:h,lift:x&&!m?J2-f:0,kept:x&&m?0:1}}function eR(i,e,t){let n=Math.max(...t.map(Math.abs)),s=sn(n);if(!(e>0))return s;let r=Math.floor((sn(i)+sn(e)+1)/2);return n>0?Math.max(s,r):r}function tR(i,e,[t,n,s],[r,o,a,l]){let c=Mt,u=xx,h=Fu,d=O=>O.map(P=>-P),f=Ou(o,a),p=Ou(r,l),g=h([...c(o,r),...c(a,l)]),m=h([...c(o,l),...c(-a,r)]),x=h([...u(g,[t]),...u(m,[-n])]),y=h([...u(g,[n]),...u(m,[t])].map(O=>2*O)),v=h([...y,...u(f,[-2*s])]),M=h([...y,...u(p,[2*s])]),w=[...c(t,t),...c(n,n)],A=h([...u(e,w),...u(i.map(O=>-2*O),f)],5),_=h([...A,...u(v,[-s])],5),b=[...i.map(O=>2*O),...c(s,-s)],I=h([...u(e,b),...d(A)],5),T=h([...u(A,[s]),...u(d(i),v)],6),L=Uu(e),D=O=>Te(Uu(O),L);return{size:L,G:i,s0:de(D(f),2),t0:de(D(p),2),u0:D([...p,...d(f)]),p:de(D(x),-2),c:D(v),cPlus:D(M),twist:D(y),F:D(_),D:D(I),w2:Uu(w),lean:D(T)}}var nR=["rest","sleeping","hanging","steady","free","planar","undulating","cusp","loop","separatrix"],za=class{constructor({moments:e,mgl:t,momentum:n,attitude:s=[1,0,0,0],epoch:r=0}){if(this.moments=to(e),this.moments[0]!==this.moments[1])throw new RangeError(`\`moments\` must be (I1, I1, I3), the first two equal; got ${JSON.stringify(this.moments)} kg m\xB2. Give one of them twice if they differ by rounding, and put the axis of symmetry third.`);this.mgl=At("mgl",t,"N m"),this.momentumAtEpoch=Sn("momentum",n,3,"kg m\xB2/s"),this.attitudeAtEpoch=no(s),this.epoch=At("epoch",r,"seconds");let o=this.momentumAtEpoch,a=_x(this.moments,this.mgl,o,this.attitudeAtEpoch),l=gx(a),c=ox(a,l),u=Math.max(...o.map((I,T)=>Math.abs(I/this.moments[T])));this._fastest=u+Math.sqrt(Math.abs(this.mgl)/this.moments[0]);let h=dx(a,l,c,K0(a,l,c));this._motion=px({top:a,points:l,rates:c,at:h,axial:o[2]});let{first:d,second:f,third:p,start:g,rates:m,phases:x}=this._motion;gu([this._fastest,...d,...f,...p,...g,...m,...x]);let[y,v,M,w]=this.attitudeAtEpoch,[A,_]=[y*y+w*w,v*v+M*M],b=.5*o.reduce((I,T,L)=>I+T/this.moments[L]*T,0);this.energy=b+this.mgl*(A-_)/(A+_),this.verticalMomentum=Ea(io(this.attitudeAtEpoch),o)[2],this.axialMomentum=o[2],Object.assign(this,iR(a,l,c))}state(e){let[t,n]=mu(e,this.epoch,this._fastest);return xu(G0(this._motion,t,n))}angularVelocity(e){let t=this.state(e).momentum;return[t[0]/this.moments[0],t[1]/this.moments[1],t[2]/this.moments[2]]}};function iR(i,e,t){let n=Q0(i,e,t);return{regime:nR[n.regime],nutationLimits:[n.lowest,n.highest],nutationPeriod:zn(n.period),precessionPerPeriod:zn(n.precessionPerPeriod),spinPerPeriod:zn(n.spinPerPeriod),precessionRate:zn(n.precessionPerPeriod/n.period),spinRate:zn(n.spinPerPeriod/n.period)}}var vx=Math.PI/180,[sR,rR,oR]=[45,60,20],Cf="turns over and over",aR=.995,lR=!0,cR=["spin.tilt","spin.rate","spin.about"],uR={body:{moments:3},spin:Is};function hR({moments:i,momentum:e,attitude:t=[1,0,0,0],epoch:n=0,mass:s}){let r=e.map((a,l)=>a/i[l]),o=Ps(r);return{moments:i,velocity:r,attitude:t,epoch:n,about:o,around:nn(r,o).around,momentum:e,mass:s??1}}function dR(i){let e=Mx(i);return[...e?[{key:"by",label:"set the body by",value:i.by??0,choices:[[0,"its moments"],[1,"the edges of a box"]]}]:[],...e&&i.by?fR(i,e):Ls(i.moments),...Ns(i)]}function fR({mass:i=1},e){let t=Math.max(...e),[n,s]=[["km",1e3],["m",1],["cm",.01],["mm",.001],["\xB5m",1e-6],["nm",1e-9]].find(([,r])=>t>=r)??["m",1];return[{key:"mass",label:"mass of the box",unit:"kg",value:i,log:!0,low:i/20,high:20*i},...e.map((r,o)=>({key:`edge.${o}`,label:W("edge along axis {axis}",{axis:o+1}),unit:n,si:s,value:r,log:!0,low:Math.max(r,.001*t)/10,high:10*Math.max(r,.001*t)}))]}function Mx({moments:i,mass:e=1}){let t=i[0]+i[1]+i[2],n=i.map(s=>6/e*(t-2*s));return n.every(s=>s>=0&&Number.isFinite(s))?n.map(Math.sqrt):null}function pR(i,e,t){let[n,s]=e.split(".");if(n==="by")return{...i,by:t};if(n!=="edge"&&n!=="mass")return Ds(i,e,t);let r=Mx(i),o=n==="mass"?t:i.mass??1;n==="edge"&&(r[Number(s)]=t);let a=r.map(c=>c*c),l=[0,1,2].map(c=>o/12*(a[(c+1)%3]+a[(c+2)%3]));return{...i,mass:o,moments:l,momentum:null}}function mR(i,e){let t=Math.hypot(...i.velocity.map((r,o)=>r*i.moments[o])),n=e.map(r=>r*t),s=n.map((r,o)=>r/i.moments[o]);return{...i,velocity:s,momentum:n,around:nn(s,i.about).around}}var gR=i=>new pi({moments:i.moments,momentum:ni(i),attitude:i.attitude,epoch:i.epoch});function xR({moments:i,velocity:e,attitude:t}){return{body:{moments:i},spin:{angular_velocity:e,attitude:t}}}var yR=(i,e)=>Us(i,e);function _R({moments:i,velocity:e,attitude:t},n){return`[body]
moments = ${Gn(i,"kg*m^2")}

[spin]
angular_velocity = ${Gn(e,"rad/s")}
attitude = [${t.map(He).join(", ")}]

[time]
until = "${He(n)} s"
`}function vR({moments:i,velocity:e},t){let n=ti(i),{period:s,regime:r}=t,o=s!==null&&Number.isFinite(s),a=bx(i,e,t,n),l=[["what it does",a]];return o&&l.push(["period of L in the body",wn(s,s)]),o&&t.precessionPerPeriod!==null&&l.push(["precession about L",W("{angle} per period",{angle:`${et(t.precessionPerPeriod/vx,5)}\xB0`})]),a===Cf&&Number.isFinite(t.flipInterval??NaN)&&l.push(["turns over every",wn(t.flipInterval,t.flipInterval)]),l.push(["regime",r]),l}function MR({moments:i,velocity:e},t){let{period:n,flipInterval:s}=t;return n===null||!Number.isFinite(n)?null:bx(i,e,t,ti(i))===Cf?s:n}function bx(i,e,{regime:t,modulus:n},s){if(t==="rest")return"at rest";if(t==="separatrix")return"runs up to the intermediate axis and stays there";if(t==="permanent"||t==="spherical")return"spins steadily";let[r,o]=bR(i,e,s),l=Number(r.toPrecision(3))===Number(o.toPrecision(3))?Rf(o):W("{least} to {most}",{least:Rf(r),most:Rf(o)});return o<sR?W("cones, its axis {angle} from L",{angle:l}):o>=rR&&(o-r>=oR||n>aR)?Cf:W("tumbles, its axis {angle} from L",{angle:l})}function Rf(i){let[e,t]=[[1,"\xB0"],[.016666666666666666,"\u2032"],[.0002777777777777778,"\u2033"],[27777777777777776e-23," mas"]].find(([n])=>i>=n)??[1,"\xB0"];return`${et(i/e,3)}${t}`}function bR(i,e,t){let[n,s,r]=t.map(m=>i[m]),o=t.map(m=>e[m]*i[m]),a=Math.hypot(...o),[l,c,u]=o.map(m=>Math.abs(m)/a),h=n===r||n*(r-s)*u*u>=r*(s-n)*l*l,d=h?n*(r-s)/(s*(r-n)):r*(s-n)/(s*(r-n)),f=h?l:u,p=Math.sqrt(f*f+(d||0)*c*c),g=Math.min(1,d>0?p/Math.sqrt(d):1);return n===r?[0,0]:[Math.asin(Math.min(p,g)),Math.asin(Math.max(p,g))].map(m=>m/vx)}var Pf={};cs(Pf,{asSpec:()=>LR,changed:()=>IR,controls:()=>CR,facts:()=>OR,first:()=>wR,from:()=>ER,kept:()=>zu,keys:()=>AR,make:()=>PR,spinAboutRotor:()=>Ax,toml:()=>UR,withSpec:()=>NR});var SR=Math.PI/30,ek=Math.PI/180,wR=["rate","rotor","spin.tilt","spin.rate"],AR={body:{moments:3},system:{kind:0,rotor_axis:3,rotor_moment:1,rotor_rate:1,rotor_drive:0,rotor_momentum:1},spin:Is};function ER({moments:i,rotor:e,rotor_moment:t=null,rotor_drive:n="constant-rate",momentum:s,attitude:r=[1,0,0,0],epoch:o=0}){let a=s.map((d,f)=>(d-e[f])/i[f]),l=Ps(a),c=Math.hypot(...e),u=c>0?e.map(d=>d/c):[0,0,1],h=nn(a,l).around;return{moments:i,velocity:a,attitude:r,epoch:o,about:l,around:h,momentum:s,axis:u,spin:c,moment:t,drive:n}}var TR=1e-9,RR={momentum_space:"L in space"},Bu=({axis:i,spin:e})=>i.map(t=>t*e),Sx=({axis:i,drive:e,velocity:t})=>e==="free"?i.reduce((n,s,r)=>n+s*t[r],0):0,ku=i=>i.spin/i.moment-Sx(i),wx=(i,e)=>({...i,spin:i.moment*(e+Sx(i)),momentum:null});function CR(i){let e=Math.max(Math.abs(i.spin),Math.hypot(...ni(i,Bu(i))))||1;return[i.moment===null?{key:"rotor",label:"momentum of the rotor",unit:"kg m\xB2/s",value:i.spin,low:-2*e,high:2*e}:{key:"rate",label:"rotor speed against the body",unit:"rpm",si:SR,value:ku(i),low:-2*e/i.moment,high:2*e/i.moment},...Ls(i.moments),...Ns(i)]}function IR(i,e,t){return e==="rotor"?{...i,spin:t,momentum:null}:e==="rate"?wx(i,t):Ds(i,e,t)}var PR=i=>new Ca({moments:i.moments,rotor:Bu(i),rotor_moment:i.moment,rotor_drive:i.drive,axis:i.axis,momentum:ni(i,Bu(i)),attitude:i.attitude,epoch:i.epoch}),LR=i=>({body:{moments:i.moments},system:i.moment===null?{kind:"gyrostat",rotor_axis:i.axis,rotor_momentum:i.spin}:{kind:"gyrostat",rotor_axis:i.axis,rotor_moment:i.moment,rotor_rate:ku(i),rotor_drive:i.drive},spin:{angular_velocity:i.velocity,attitude:i.attitude}});function NR(i,e){let{system:t={}}=e,n={...i};if(t.rotor_axis){let a=Math.hypot(...t.rotor_axis);if(!(a>0))throw new RangeError("system.rotor_axis must have a direction; got zeros.");Object.assign(n,{axis:t.rotor_axis.map(l=>l/a),momentum:null})}let s=[t.rotor_rate,t.rotor_moment,t.rotor_drive].some(a=>a!==void 0),r=t.rotor_rate??(n.moment===null?null:ku(n));if(t.rotor_moment!==void 0&&Object.assign(n,{moment:t.rotor_moment,momentum:null}),t.rotor_drive!==void 0&&Object.assign(n,{drive:t.rotor_drive,momentum:null}),t.rotor_momentum!==void 0&&Object.assign(n,{spin:t.rotor_momentum,momentum:null}),s&&n.moment===null)throw new RangeError("system.rotor_rate needs system.rotor_moment, the rotor's own moment of inertia.");let o=s?e.spin?.momentum:null;return o&&(n.spin=DR(n,r,e.body?.moments??n.moments,o)),n=Us(n,e,Bu(n)),s&&!o&&r!==null?wx(n,r):n}function DR({axis:i,moment:e,drive:t},n,s,r){if(t!=="free")return e*n;let o=a=>i.reduce((l,c,u)=>l+c*a[u]/s[u],0);return e*(n+o(r))/(1+e*o(i))}function UR(i,e){let{axis:t,moment:n,drive:s,velocity:r,attitude:o}=i,a=t.findIndex(c=>Math.abs(c)===1);if(n===null||s==="free"&&a<0)return null;let l=i.moments.map((c,u)=>s==="free"&&u===a?c+n:c);return`[body]
moments = ${Gn(l,"kg*m^2")}

[system]
kind = "gyrostat"
rotor_axis = [${t.map(He).join(", ")}]
rotor_moment = "${He(n)} kg*m^2"
rotor_rate = "${He(ku(i))} rad/s"
rotor_drive = "${s}"

[spin]
angular_velocity = ${Gn(r,"rad/s")}
attitude = [${o.map(He).join(", ")}]

[time]
until = "${He(e)} s"
`}var FR={minimum:"stable, also with losses in the body: least energy",maximum:"stable until losses act: most energy",saddle:"unstable: a saddle of the energy"};function OR(i,e){let t=e.state(e.epoch),n=Math.hypot(...t.momentum),s=Na(t.attitude,t.momentum).map(o=>o/(n||1)),r=[];if(n>0){let{least:o,most:a,around:l}=Eu(e,({attitude:u})=>Na(u,i.axis),s);r.push(["rotor's axis leans from L",Au(o,a)]),r.push(["precession of the rotor's axis about L",fi(l)]);let c=Ax(i,n);c&&(r.push(["a spin about the rotor's axis",FR[c.extremum]]),c.nutation&&r.push(["nutation: L goes round it in the body every",wn(2*Math.PI/c.nutation,2*Math.PI/c.nutation)]))}return[...r,...zu(e)]}function Ax({moments:i,axis:e,spin:t},n){let s=e.findIndex(l=>Math.abs(Math.abs(l)-1)<TR);if(s<0)return null;let r=(n-t)/i[s],[o,a]=[1,2].map(l=>n/i[(s+l)%3]-r);return{extremum:o*a<=0?"saddle":o>0?"minimum":"maximum",nutation:o*a>0?Math.sqrt(o*a):null}}function zu(i){let e=i.state(i.epoch),t=Math.hypot(...e.velocity)||1,n=i.state(i.epoch+40*Math.PI/t);return Object.entries(e.invariants).map(([s,r])=>{let[o,a]=[[r].flat(),[n.invariants[s]].flat()],l=Math.hypot(...o)||1;return[W("{quantity}, change in 20 turns",{quantity:W(RR[s]??s)}),et(Math.hypot(...o.map((c,u)=>c-a[u]))/l,2)]})}var Lf={};cs(Lf,{asSpec:()=>$R,changed:()=>qR,controls:()=>WR,facts:()=>jR,first:()=>GR,from:()=>HR,keys:()=>VR,make:()=>XR,standsUpright:()=>Tx,toml:()=>ZR,withSpec:()=>YR});var Ex=9.80665,BR=Math.PI/180,kR=1e-5,zR=.01*BR,GR=["spin.rate","spin.tilt","mgl"],VR={system:{kind:0,moments:3,mgl:1,axis:3},spin:Is};function HR({moments:i,mgl:e,axis:t,momentum:n,attitude:s=[1,0,0,0],epoch:r=0}){let o=n.map((l,c)=>l/i[c]),a=Ps(o);return{moments:i,velocity:o,attitude:s,epoch:r,about:a,around:nn(o,a).around,momentum:n,mgl:e,axis:t}}var WR=i=>[{key:"mgl",label:"weight \xD7 distance to the centre of mass",unit:"N m",value:i.mgl,low:0,high:5*Math.abs(i.mgl)||1},...Ls(i.moments),...Ns(i)],qR=(i,e,t)=>e==="mgl"?{...i,mgl:t}:Ds(i,e,t),XR=i=>new Ia({...i,momentum:ni(i)}),$R=({moments:i,mgl:e,axis:t,velocity:n,attitude:s})=>({system:{kind:"heavy-top",moments:i,mgl:e,axis:t},spin:{angular_velocity:n,attitude:s}});function YR(i,e){let{system:t={}}=e,n={...i};return t.mgl!==void 0&&(n.mgl=Number(t.mgl)),t.axis&&(n.axis=t.axis.map(Number)),Us(n,t.moments?{...e,body:{moments:t.moments}}:e)}function ZR(i,e){let{moments:t,mgl:n,axis:s,velocity:r,attitude:o}=i,a=Math.hypot(...s),l=s.map(g=>g/a),c=[0,1,2].map(g=>.5*(t[0]+t[1]+t[2])-t[g]),u=l.reduce((g,m,x)=>g+(m?m*m/c[x]:0),0);if(n&&!(u>0&&Number.isFinite(u)))return null;let h=n?.5/u:0,d=n?h*Ex/n:0,f=n?n/(Ex*d):1,p=[0,1,2].map(g=>[0,1,2].map(m=>(g===m?t[g]-h:0)+h*l[g]*l[m]));return`# a body with the moments ${t.map(g=>et(g)).join(", ")} kg m\xB2 about its point, and mgl = ${et(n)} N m
[body]
mass = "${He(f)} kg"
inertia = [${p.map(g=>Gn(g,"kg*m^2")).join(", ")}]

[system]
kind = "heavy-top"
pivot = ${Gn(l.map(g=>-d*g),"m")}

[spin]
angular_velocity = ${Gn(r,"rad/s")}
attitude = [${o.map(He).join(", ")}]

[time]
until = "${He(e)} s"
`}function jR({moments:i,mgl:e,axis:t,velocity:n},s){let r=Math.hypot(...t),o=t.map(f=>f/r),{least:a,most:l,swing:c,around:u}=Eu(s,({attitude:f})=>Na(f,o)),h=[["axis leans",Au(a,l)]];c!==null&&l-a>zR&&h.push(["nutation: nods every",wn(c,c)]),h.push(["mean precession",fi(u)]);let d=o.findIndex(f=>Math.abs(Math.abs(f)-1)<kR);if(d>=0){let f=n[d]*o[d];f&&e&&h.push(["a gyroscope's, mgl/I\u2083\u03C9",fi(e/(i[d]*f))]),h.push(["upright at this spin, to first order",Tx(i,e,d,f)?"stable: it would sleep":"unstable: it would fall"])}return[...h,...zu(s)]}function Tx(i,e,t,n){let[s,r,o]=[i[(t+1)%3],i[(t+2)%3],i[t]],[a,l]=[(o-r)*n*n-e,(o-s)*n*n-e],[c,u,h]=[s*r,s*l+r*a+((s+r-o)*n)**2,a*l];return u>0&&h>0&&u*u>4*c*h}var Df={};cs(Df,{asSpec:()=>aC,changed:()=>rC,controls:()=>sC,facts:()=>hC,first:()=>tC,from:()=>iC,keys:()=>nC,make:()=>oC,toml:()=>cC,withSpec:()=>lC});var KR=Math.PI/30,JR=Math.PI/180,Rx=9.80665,QR=1e-6,eC=1e-9,tC=["lean","spin","precession"],nC={system:{kind:0,moments:3,mgl:1,lean:1},spin:{spin:1,precession:1,nutation_rate:1,lean:1,momentum:3,attitude:4}};function iC({moments:i,mgl:e,momentum:t,attitude:n=[1,0,0,0],epoch:s=0}){return{moments:i,mgl:e,...Nf(i,t,n),momentum:t,attitude:n,epoch:s}}function Nf(i,e,[t,n,s,r]){let o=e.map((p,g)=>p/i[g]),a=[2*(n*r-t*s),2*(s*r+t*n),t*t-n*n-s*s+r*r],l=Math.hypot(a[0],a[1]),c=2*Math.atan2(Math.hypot(n,s),Math.hypot(t,r));if(l<eC)return{lean:c<1?0:Math.PI,spin:o[2],precession:0,nutation:0,phi:2*Math.atan2(r,t),psi:0};let u=Math.atan2(r,t),h=Math.atan2(s,n),d=(o[0]*a[0]+o[1]*a[1])/l**2,f=(o[0]*a[1]-o[1]*a[0])/l;return{lean:c,precession:d,nutation:f,spin:o[2]-d*Math.cos(c),phi:u+h,psi:u-h}}function Cx({moments:i,lean:e,spin:t,precession:n,nutation:s,phi:r,psi:o}){let[a,l]=[Math.cos(.5*e),Math.sin(.5*e)],[c,u]=[.5*(r+o),.5*(r-o)],h=[a*Math.cos(c),l*Math.cos(u),l*Math.sin(u),a*Math.sin(c)],d=[n*Math.sin(e)*Math.sin(o)+s*Math.cos(o),n*Math.sin(e)*Math.cos(o)-s*Math.sin(o),n*Math.cos(e)+t];return{attitude:h,momentum:d.map((f,p)=>f*i[p])}}function sC(i){let{moments:e,mgl:t,lean:n,spin:s,precession:r,nutation:o}=i,a=Math.max(Math.abs(s),Math.abs(r),Math.sqrt(Math.abs(t)/e[0]),1e-6),l={unit:"rpm",si:KR,low:-5*a,high:5*a};return[{key:"moments.0",label:"moment of inertia across, at the point",unit:"kg m\xB2",value:e[0],log:!0,low:Math.max(e[0]/10,.5*e[2]),high:10*e[0]},{key:"moments.2",label:"moment of inertia about the axis",unit:"kg m\xB2",value:e[2],log:!0,low:e[2]/10,high:Math.min(10*e[2],2*e[0])},{key:"mgl",label:"weight \xD7 distance to the centre of mass",unit:"N m",value:t,low:0,high:5*Math.abs(t)||1},{key:"lean",label:"lean",unit:"\xB0",si:JR,value:n,low:0,high:Math.PI},{key:"spin",label:"spin about its axis",value:s,...l},{key:"precession",label:"precession at the start",value:r,...l},{key:"nutation",label:"nutation at the start",value:o,...l}]}function rC(i,e,t){let n={...i};return e==="moments.0"?n.moments=[t,t,i.moments[2]]:e==="moments.2"?n.moments=[i.moments[0],i.moments[1],t]:n[e]=t,{...n,...Cx(n)}}function oC({moments:i,mgl:e,momentum:t,attitude:n,epoch:s}){return new za({moments:i,mgl:e,momentum:t,attitude:n,epoch:s})}function aC({moments:i,mgl:e,attitude:t,lean:n,spin:s,precession:r,nutation:o}){return{system:{kind:"lagrange-top",moments:i,mgl:e,lean:n},spin:{spin:s,precession:r,nutation_rate:o,attitude:t}}}function lC(i,{system:e={},spin:t={}}){let n={...i};if(e.moments&&(n.moments=e.moments.map(Number)),e.mgl!==void 0&&(n.mgl=Number(e.mgl)),t.attitude){let o=t.attitude.map(Number),a=(t.momentum??i.momentum).map(Number);n={...n,...Nf(n.moments,a,o),attitude:o,momentum:a}}else if(t.momentum){let o=t.momentum.map(Number);return{...n,...Nf(n.moments,o,n.attitude),momentum:o}}let s={lean:e.lean??t.lean,spin:t.spin,precession:t.precession,nutation:t.nutation_rate},r=Object.entries(s).filter(([,o])=>o!==void 0);if(!r.length&&!e.moments)return n;for(let[o,a]of r)n[o]=Number(a);return{...n,...Cx(n)}}function cC(i,e){let{moments:t,mgl:n,attitude:s,momentum:r}=i,o=.5*Math.min(.5*t[0],t[0]-.5*t[2]),a=o>0&&n?(n/Rx)**2/o:1,l=n/(a*Rx),c=t[0]-a*l*l,u=r.map((h,d)=>h/t[d]);return`# a body with these moments about its point, ${et(t[0])} and ${et(t[2])} kg m\xB2, and mgl = ${et(n)} N m
[body]
mass = "${He(a)} kg"
moments = ["${He(c)} kg*m^2", "${He(c)} kg*m^2", "${He(t[2])} kg*m^2"]

[system]
kind = "lagrange-top"
pivot = ["0 m", "0 m", "${He(-l)} m"]

[spin]
angular_velocity = [${u.map(h=>`"${He(h)} rad/s"`).join(", ")}]
attitude = [${s.map(He).join(", ")}]

[time]
until = "${He(e)} s"
`}var uC={rest:"at rest",sleeping:"stands upright and spins",hanging:"hangs and spins",steady:"goes round at constant lean",free:"no weight: turns freely",planar:"swings like a pendulum",undulating:"nods while it goes round, always onward",cusp:"nods, halting at cusps",loop:"nods in loops",separatrix:"rises to the vertical and stays there"};function hC({moments:i,spin:e,mgl:t},n){let[s,r]=n.nutationLimits??[0,1],o=r-s<QR&&n.regime==="undulating"?"steady":n.regime,a=[["what it does",uC[o]??o]],l=n.nutationPeriod,c=l!==null&&Number.isFinite(l);return c&&o!=="steady"&&a.push(["nods every",wn(l,l)]),c&&n.precessionPerPeriod!==null&&n.regime!=="planar"&&a.push(["mean precession",fi(n.precessionPerPeriod/l)]),e&&t&&a.push(["a gyroscope's, mgl/I\u2083\u03C9",fi(t/(i[2]*e))]),t>0&&a.push(["sleeps upright from",fi(2*Math.sqrt(t*i[0])/i[2])]),a}var Of={};cs(Of,{QuantumMotion:()=>Wu,asSpec:()=>kC,changed:()=>UC,controls:()=>DC,dragged:()=>IC,facts:()=>GC,first:()=>PC,from:()=>NC,keys:()=>LC,make:()=>BC,withDirection:()=>FC,withSpec:()=>zC});var Px=2*Math.PI,dC=.5*(Math.sqrt(5)-1),fC=1-1e-15,Lx=1e-12;function pC(i,e){let[t,n]=[1,Math.sqrt(1-e)],s=[];for(;t-n>Lx*t;){let[a,l]=[.5*(t+n),.5*(t-n)];n=Math.sqrt(t*n),t=a,s.push(l/a)}let r=2**s.length*t*i;for(let a of s.reverse())r=.5*(r+Math.asin(a*Math.sin(r)));let o=Math.sin(r);return[o,Math.cos(r),Math.sqrt(1-e*o*o)]}function mC(i,e){let[t,n,s,r]=[1,Math.sqrt(1-e),i,1];for(;t-n>Lx*t;){let o=Math.round(s/Math.PI)*Math.PI;s+=Math.atan(n/t*Math.tan(s-o))+o,[t,n,r]=[.5*(t+n),Math.sqrt(t*n),2*r]}return s/(r*t)}var Uf=class{constructor([e,t,n],s,r){let[o,a,l]=r;this.unit=r,this.aboveSaddle=(e-t)*o*o>(t-n)*l*l;let c=(e-n)*o*o+(t-n)*a*a,u=(e-t)*a*a+(e-n)*l*l;if(!(u>0)||!(c>0)){this.rate=0;return}let[h,d]=this.aboveSaddle?[c,u]:[u,c],[f,p]=this.aboveSaddle?[e-t,t-n]:[t-n,e-t];this.m=Math.min(fC,p*d/(f*h)),this.rate=2*Px*s*Math.sqrt(f*h);let g=this.aboveSaddle?o:l;this.sign=g<0?-1:1,this.long=this.sign*Math.sqrt(h/(e-n)),this.middle=this.sign*Math.sqrt(d/f),this.short=Math.sqrt(d/(e-n)),this.phase=mC(Math.atan2(a/this.middle,(this.aboveSaddle?l:o)/this.short),this.m)}at(e){if(!this.rate)return this.unit;let[t,n,s]=pC(this.rate*e+this.phase,this.m),[r,o,a]=[this.long*s,this.middle*t,this.short*n];return this.aboveSaddle?[r,o,a]:[a,o,r]}};function Nx(i,e,t,n){let s=Math.abs(t[0])<.6?[1,0,0]:[0,0,1],r=Ga(Ix(t,s)),o=Ix(t,r);return Array.from({length:n},(a,l)=>{let c=((l+.5)/n)**(1/(4*e+1)),u=2*Math.asin(Math.sqrt(1-c)),h=Px*(l*dC%1),[d,f,p]=[Math.sin(u)*Math.cos(h),Math.sin(u)*Math.sin(h),Math.cos(u)];return new Uf(i,e+.5,Ga(t.map((g,m)=>d*r[m]+f*o[m]+p*g)))})}var Ix=(i,e)=>[0,1,2].map(t=>i[(t+1)%3]*e[(t+2)%3]-i[(t+2)%3]*e[(t+1)%3]),Ga=i=>i.map(e=>e/Math.hypot(...i));var gC=4,xC=1e-13,Ux=(i,e,t,n,s)=>{let r=1-s;return i.clone().multiplyScalar(r*r*(1+2*s)).addScaledVector(e,s*s*(3-2*s)).addScaledVector(t,s*r*r).addScaledVector(n,-s*s*r)},Dx=(i,e,t)=>i+t*(e-i);function Fx(i,e,t,n,s){let r=p=>new C(...i.map((g,m)=>p.getComponent(m)/g)),[o,a]=[r(e.momentum),r(t.momentum)],l=(p,g)=>p.clone().cross(g).multiplyScalar(n),c=Ux(e.momentum,t.momentum,l(e.momentum,o),l(t.momentum,a),s),u=yC(i,e.momentum,t.momentum,c,s);if(!e.attitude)return{momentum:u,attitude:null};let h=_C(e.attitude,t.attitude,o.multiplyScalar(n),a.multiplyScalar(n),s),d=e.momentum.clone().applyQuaternion(e.attitude);d.lerp(t.momentum.clone().applyQuaternion(t.attitude),s).normalize();let f=u.clone().applyQuaternion(h).normalize();return{momentum:u,attitude:new ot().setFromUnitVectors(f,d).multiply(h)}}function yC(i,e,t,n,s){let r=Dx(e.length(),t.length(),s);if(!(r>0))return n;let o=Math.min(...i),a=new C(...i.map(h=>o/h)),l=h=>h.clone().multiply(a).dot(h),c=Dx(l(e.clone().divideScalar(r)),l(t.clone().divideScalar(r)),s),u=n.clone().divideScalar(r);for(let h=0;h<gC;h++){let d=u.clone().multiply(a),[f,p,g]=[u.dot(u),u.dot(d),d.dot(d)],m=f*g-p*p;if(m<xC)return u.normalize().multiplyScalar(r);let[x,y]=[.5*(1-f),.5*(c-p)];u.addScaledVector(u.clone(),(x*g-y*p)/m).addScaledVector(d,(y*f-x*p)/m)}return u.multiplyScalar(r)}function _C(i,e,t,n,s){let r=i.clone().invert().multiply(e);r.w<0&&r.set(-r.x,-r.y,-r.z,-r.w);let o=new C(r.x,r.y,r.z),a=o.length(),l=2*Math.atan2(a,r.w),c=o.multiplyScalar(a>0?l/a:2),u=l>.001?1/l**2-1/(2*l*Math.tan(l/2)):1/12,h=c.clone().cross(n),d=n.clone().addScaledVector(h,.5).addScaledVector(c.clone().cross(h),u),f=Ux(new C,c,t,d,s),p=f.length();return p>0?i.clone().multiply(new ot().setFromAxisAngle(f.divideScalar(p),p)):i.clone()}var vC=.08,MC=24e3,bC={f8:Float64Array,f4:Float32Array,u4:Uint32Array,u2:Uint16Array,u1:Uint8Array};function ht(i){if(!i)return null;let e=atob(i.data),t=new Uint8Array(e.length);for(let n=0;n<e.length;n++)t[n]=e.charCodeAt(n);return new bC[i.kind](t.buffer)}var Gu=class{constructor(e){this.times=ht(e.times),this.attitudes=ht(e.attitude),this.momenta=ht(e.momentum),this.velocities=ht(e.velocity),this.energies=ht(e.energy),this.joined=e.joined,this.space=new ot(e.space[1],e.space[2],e.space[3],e.space[0]),this.count=this.times.length,this.fastest=SC(this.velocities),this.free=e.free,this.fine=this.finely()}finely(){if(!this.joined||!this.free||!this.momenta)return 1;let e=0;for(let n=1;n<this.count;n++)e=Math.max(e,this.times[n]-this.times[n-1]);let t=Math.ceil(this.fastest*e/vC);return Math.max(1,Math.min(t,Math.floor(MC/this.count)))}get states(){return this.dense??=Array.from({length:(this.count-1)*this.fine+1},(e,t)=>this.at(t/this.fine)),this.dense}get span(){return this.times[this.count-1]-this.times[0]}attitude(e){let[t,n,s,r]=this.attitudes.subarray(4*e,4*e+4);return new ot(n,s,r,t)}at(e){let t=Math.min(Math.floor(e),this.count-1),n=this.joined&&t+1<this.count?e-t:0,s=a=>n?a[t]+n*(a[t+1]-a[t]):a[t],r=a=>{if(!a)return null;let l=new C().fromArray(a,3*t);return n?l.lerp(new C().fromArray(a,3*t+3),n):l},o={position:t+n,time:s(this.times),attitude:this.attitudes?this.attitude(t):null,momentum:r(this.momenta),velocity:r(this.velocities),energy:this.energies?s(this.energies):null};return n&&this.free&&this.momenta?Object.assign(o,this.freely(t,n)):n&&this.attitudes&&o.attitude.slerp(this.attitude(t+1),n),o}freely(e,t){let[n,s]=[e,e+1].map(a=>({momentum:new C().fromArray(this.momenta,3*a),attitude:this.attitudes?this.attitude(a):null})),r=Fx(this.free,n,s,this.times[e+1]-this.times[e],t),o=new C(...this.free.map((a,l)=>r.momentum.getComponent(l)/a));return{...r,velocity:this.velocities?o:null}}positionOf(e){let t=0,n=this.count-1;for(;n-t>1;){let r=t+n>>1;this.times[r]<=e?t=r:n=r}if(e>=this.times[n])return n;let s=this.times[n]-this.times[t];return t+(s>0?Math.max(0,(e-this.times[t])/s):0)}};function SC(i){let e=0;for(let t=0;i&&t<i.length;t+=3)e=Math.max(e,Math.hypot(i[t],i[t+1],i[t+2]));return e}var wC=2*Math.PI,Vu=class{constructor({J:e,energies:t,vectors:n,kernel:s}){this.J=e,this.size=2*e+1,this.energies=t,this.middle=t.reduce((r,o)=>r+o,0)/this.size,this.vectors=ht(n),this.kernel=s}level(e){return{re:Float64Array.from({length:this.size},(t,n)=>this.vectors[n*this.size+e]),im:new Float64Array(this.size)}}coherent([e,t,n]){let{J:s,size:r}=this,[o,a]=[Math.atan2(Math.hypot(e,n),t),Math.atan2(e,n)],[l,c]=[Math.log(Math.cos(.5*o)),Math.log(Math.sin(.5*o))],[u,h]=[new Float64Array(r),new Float64Array(r)],d=0;for(let f=0;f<r;f++){let[p,g]=[2*s-f,s-f],m=.5*d+(p?p*l:0)+(f?f*c:0);u[f]=Math.exp(m)*Math.cos(g*a),h[f]=-Math.exp(m)*Math.sin(g*a),d+=Math.log((2*s-f)/(f+1))}return{re:u,im:h}}parts({re:e,im:t}){let{size:n,vectors:s}=this,[r,o]=[new Float64Array(n),new Float64Array(n)];for(let a=0;a<n;a++)for(let l=0;l<n;l++)r[l]+=s[a*n+l]*e[a],o[l]+=s[a*n+l]*t[a];return{x:r,y:o}}at({x:e,y:t},n){let{size:s,vectors:r}=this,[o,a]=[new Float64Array(s),new Float64Array(s)];for(let l=0;l<s;l++){if(e[l]===0&&t[l]===0)continue;let c=(this.energies[l]-this.middle)*n,u=wC*(c-Math.round(c)),[h,d]=[Math.cos(u),Math.sin(u)],[f,p]=[h*e[l]-d*t[l],d*e[l]+h*t[l]];for(let g=0;g<s;g++)o[g]+=r[g*s+l]*f,a[g]+=r[g*s+l]*p}return{re:o,im:a}}mean({re:e,im:t}){let{J:n,size:s}=this,[r,o,a]=[0,0,0];for(let l=0;l<s;l++){if(o+=(n-l)*(e[l]*e[l]+t[l]*t[l]),l+1===s)continue;let c=Math.sqrt((l+1)*(2*n-l));a+=c*(e[l]*e[l+1]+t[l]*t[l+1]),r+=c*(e[l]*t[l+1]-t[l]*e[l+1])}return[r/n,o/n,a/n]}};function AC(i,e){let[t,n]=[Math.cos(.5*e),Math.sin(.5*e)],s=Float64Array.of(1);for(let r=1;r<=2*i;r++){let o=new Float64Array((r+1)*(r+1));for(let a=0;a<=r;a++)for(let l=0;l<=r;l++){let c=0;a<r&&l<r&&(c+=t*Math.sqrt((r-a)*(r-l))*s[a*r+l]),a<r&&l>0&&(c-=n*Math.sqrt((r-a)*l)*s[a*r+l-1]),a>0&&l<r&&(c+=n*Math.sqrt(a*(r-l))*s[(a-1)*r+l]),a>0&&l>0&&(c+=t*Math.sqrt(a*l)*s[(a-1)*r+l-1]),o[a*(r+1)+l]=c/r}s=o}return s}function EC(i,e,t){let n=2*i+1,s=AC(i,e),r=s.map((l,c)=>l*t[c%n]),o=new Float64Array(n*(n+1)/2),a=0;for(let l=0;l<n;l++)for(let c=0;c+l<n;c++){let u=0;for(let h=0;h<n;h++)u+=r[c*n+h]*s[(c+l)*n+h];o[a++]=u}return o}var Hu=class{constructor(e,t,n){[this.J,this.rows,this.columns]=[e,n,2*n];let s=2*e+1;this.kernels=Array.from({length:n},(o,a)=>EC(e,(a+.5)*Math.PI/n,t));let r=o=>(o+.5)*2*Math.PI/this.columns;this.cosines=Array.from({length:s},(o,a)=>Float64Array.from({length:this.columns},(l,c)=>Math.cos(a*r(c)))),this.sines=Array.from({length:s},(o,a)=>Float64Array.from({length:this.columns},(l,c)=>Math.sin(a*r(c))))}of({re:e,im:t}){let{rows:n,columns:s}=this,r=2*this.J+1,[o,a]=[new Float64Array(r*(r+1)/2),new Float64Array(r*(r+1)/2)],l=0;for(let h=0;h<r;h++)for(let d=0;d+h<r;d++,l++){let f=h?2:1;o[l]=f*(e[d]*e[d+h]+t[d]*t[d+h]),a[l]=f*(e[d]*t[d+h]-t[d]*e[d+h])}let c=new Float32Array(n*s),u=new Float64Array(s);for(let h=0;h<n;h++){let d=this.kernels[h];u.fill(0);let f=0;for(let p=0;p<r;p++){let[g,m]=[0,0];for(let v=0;v+p<r;v++,f++)g+=d[f]*o[f],m+=d[f]*a[f];let[x,y]=[this.cosines[p],this.sines[p]];for(let v=0;v<s;v++)u[v]+=g*x[v]+m*y[v]}c.set(u,h*s)}return c}};var Ox=Math.PI/180,Pi=-1,TC=400,RC=500,[Bx,CC]=[[64,192],6],IC=!0,PC=["state.level","state.lean","state.towards"],LC={state:{level:1,direction:3}};function NC(i){let e=i.vectors?new Vu(i):null;return{...i,spin:e,rotor:{map:null},level:i.level??Pi,first:i.direction}}function DC({spin:i,levels:e,level:t,direction:n}){let s=e.map(({name:l},c)=>[c,l]),r={key:"state.level",label:i?"state":"level",value:t,choices:i?[[Pi,"L as sharp as it can be"],...s]:s};if(t!==Pi)return[r];let{lean:o,towards:a}=Ff(n);return[r,{key:"state.lean",label:"L leans from the b axis by",unit:"\xB0",si:Ox,value:o,low:0,high:Math.PI},{key:"state.towards",label:"towards (0\xB0 is a, 90\xB0 is c)",unit:"\xB0",si:Ox,value:a,low:-Math.PI,high:Math.PI}]}var Ff=([i,e,t])=>({lean:Math.atan2(Math.hypot(i,t),e),towards:i||t?Math.atan2(t,i):0});function UC(i,e,t){if(e==="state.level")return kx(i,t);let{lean:n,towards:s}={...Ff(i.direction),towards:i.towards??Ff(i.direction).towards,[e.split(".")[1]]:t},r=[Math.sin(n)*Math.cos(s),Math.cos(n),Math.sin(n)*Math.sin(s)];return{...i,direction:r,towards:s,level:Pi}}function kx(i,e){let t=Number(e);if(t===Pi&&i.spin)return{...i,level:t};if(!Number.isInteger(t)||!i.levels[t])throw new RangeError(`state.level must be a whole number from 0 to ${i.levels.length-1}; got ${e}.`);return{...i,level:t,direction:i.levels[t].start}}function FC(i,e){if(i.level===Pi)return{...i,direction:e,towards:null};let t=o=>o.reduce((a,l,c)=>a+i.constants[c]*l*l,0),n=t(e),s=i.levels.map(({start:o})=>Math.abs(t(o)-n)),r=s.indexOf(Math.min(...s));return{...i,level:r,direction:OC(i.constants,i.levels[r].start,e)}}function OC([i,e,t],n,s){let r=i*n[0]**2+t*n[2]**2,o=r>e,[a,l]=o?[0,2]:[2,0],c=Math.sqrt((o?i-r:r-t)/(o?i-e:e-t)),u=Math.abs(n[l]);if(!(u>0)||!Number.isFinite(c))return n;let h=Math.atan2(s[1]/c,s[l]/u),d=[0,0,0];return[d[l],d[1]]=[u*Math.cos(h),Math.min(1,c)*Math.sin(h)],d[a]=(s[a]<0?-1:1)*Math.sqrt(Math.max(0,1-d[l]**2-d[1]**2)),Ga(d)}var Wu=class extends pi{constructor({moments:e,constants:t,momentumSize:n,attitude:s,direction:r,level:o,levels:a,spin:l,rotor:c,J:u}){super({moments:e,momentum:r.map(h=>h*n),attitude:s,epoch:0}),[this.constants,this.spin,this.J,this.rotor]=[t,l,u,c],this.level=o===Pi?null:o,this.ladder=a,this.direction=r,this.parts=this.level===null?l.parts(l.coherent(r)):null,this.wanted=this.level===null?this.flipping():null}flipping(){let[e,t,n]=this.constants,s=4*Math.PI*(this.J+.5)*Math.sqrt((e-t)*(t-n)),r=Number.isFinite(this.period??NaN)?this.period:1/0,o=Math.min(3*r,2*(2*Math.log(this.J)+8)/s);return Number.isFinite(o)?o:null}spinAt(e){return this.parts?this.spin.at(this.parts,e):this.spin.level(this.level)}get map(){let e=Math.min(Bx[1],Math.max(Bx[0],CC*this.J));return this.rotor.map??=new Hu(this.J,this.spin.kernel,e),this.rotor.map}get cloud(){return this.members??=this.parts?Nx(this.constants,this.J,this.direction,TC):[],this.members}plots(e){if(!this.parts)return null;let t=Math.max(1,Math.ceil(e.length/RC)),n=e.filter((c,u)=>u%t===0||u===e.length-1),s=Math.hypot(...this.state(0).momentum),r=n.map(c=>this.spin.mean(this.spinAt(c))),o=n.map(c=>this.state(c).momentum[1]/s),a=n.map(c=>this.meanOfCloud(c)[1]),l=(c,u)=>({name:c,times:n,values:u});return[{title:"L along the b axis, in |L|",unit:"",series:[{...l("quantum \u27E8L\u27E9",r.map(c=>c[1])),role:"motion"},{...l("one classical body",o),role:"classical"},{...l("mean of classical bodies",a),role:"ensemble"}]},{title:"quantum \u27E8L\u27E9 along the axes, in J",unit:"",along:!0,series:["a","b","c"].map((c,u)=>l(c,r.map(h=>h[u])))}]}meanOfCloud(e){let t=[0,0,0];for(let n of this.cloud)n.at(e).forEach((s,r)=>t[r]+=s);return t.map(n=>n/this.cloud.length*((this.J+.5)/this.J))}},BC=i=>new Wu(i),kC=({level:i,direction:e})=>({state:i===Pi?{direction:e}:{level:i}});function zC(i,{state:e={}}){if(e.direction){if(!i.spin)throw new RangeError(`state.direction asks for a state of a spin, which the page has up to J = ${i.largestJ}. Set state.level.`);if(!(Math.hypot(...e.direction)>0))throw new RangeError("state.direction must not be zero.");return{...i,level:Pi,direction:Ga(e.direction),towards:null}}return e.level===void 0?i:kx(i,e.level)}function GC({level:i,levels:e,constants:t,J:n,said:s,direction:r,first:o},a){if(i!==Pi)return e[i].said;let l=(n+.5)**2*r.reduce((h,d,f)=>h+t[f]*d*d,0),c=[["classical energy E/hc",`${et(l/29979245800,7)} cm\u207B\xB9`]],{period:u}=a;return u!==null&&Number.isFinite(u)&&c.push(["classical L goes round its polhode in",wn(u,u)]),r===o?[...c,...s]:c}var zx={DampedBody:uf,EulerDisk:df,FreeMotion:If,Gyrostat:Pf,HeavyTop:Lf,LagrangeMotion:Df,QuantumRotor:Of};var Gx=.08,VC=8,[HC,WC]=[400,3e3],qC=24e3,Vx=16*Number.EPSILON,Bf=.5,qu=([i,e,t,n])=>new ot(e,t,n,i),Xu=class i{constructor(e,t=null,n=null){this.solver=e,this.moments=e.moments,this.free=e instanceof pi?e.moments:null,this.hasUp=e.mgl!==void 0||!!e.onPlane,this.endless=!0,this.joined=!0,this.times=t?.length?t:this.window(e.epoch),this.count=this.times.length,this.space=n?qu(n):this.upright(),this.fill(),this.fine=Math.max(1,Math.min(Math.ceil(this.fastest*this.span/(Gx*(this.count-1||1))),Math.floor(qC/this.count)))}window(e){let t=this.solver.mgl?.1*Math.sqrt(Math.abs(this.solver.mgl)/Math.max(...this.moments)):0,n=Math.max(this.speedAt(e),t)||1,s=this.solver.wanted??XC(this.solver,n);s>0&&Number.isFinite(s*n)||kf();let r=Math.max(HC,Math.min(WC,Math.ceil(s*n/Gx)+1));return Float64Array.from({length:r},(o,a)=>e+s*a/(r-1))}speedAt(e){return Math.hypot(...this.solved(e).velocity)}upright(){if(this.hasUp)return new ot;let{attitude:e,momentum:t}=this.solver.state(this.solver.epoch),n=new C(...t).applyQuaternion(qu(e));return n.length()>0?new ot().setFromUnitVectors(n.normalize(),new C(0,0,1)):new ot}fill(){this.attitudes=new Float64Array(4*this.count),this.momenta=new Float64Array(3*this.count),this.velocities=new Float64Array(3*this.count),this.energies=new Float64Array(this.count),this.fastest=0;let e=0;this.dense=null;for(let t=0;t<this.count;t++){let{attitude:n,momentum:s,velocity:r,energy:o}=this.solved(this.times[t]);this.attitudes.set(n,4*t),this.momenta.set(s,3*t),this.velocities.set(r,3*t),this.fastest=Math.max(this.fastest,Math.hypot(...r)),this.energies[t]=o,e=Math.max(e,Math.hypot(...s))}(!Hx(e)||!Hx(this.fastest))&&kf();for(let t of[this.times,this.attitudes,this.momenta,this.velocities,this.energies])t.every(Number.isFinite)||kf()}solved(e){let t=this.solver.state(e);if(t.velocity)return t;let n=t.momentum.map((c,u)=>c/this.moments[u]),s=.5*t.momentum.reduce((c,u,h)=>c+u*n[h],0),[r,o,a,l]=t.attitude;return{...t,velocity:n,energy:this.hasUp?s+this.solver.mgl*(r*r-o*o-a*a+l*l):s}}get states(){return this.dense??=Array.from({length:(this.count-1)*this.fine+1},(e,t)=>this.at(t/this.fine)),this.dense}get span(){return this.times[this.count-1]-this.times[0]}attitude(e){return qu(this.attitudes.subarray(4*e,4*e+4))}at(e){let t=Math.min(Math.floor(e),this.count-1),n=t+1<this.count?e-t:0,s=n?this.times[t]+n*(this.times[t+1]-this.times[t]):this.times[t];return{position:t+n,...this.solvedAt(s)}}solvedAt(e){let{attitude:t,momentum:n,velocity:s,energy:r}=this.solved(e);return{time:e,attitude:qu(t),momentum:new C(...n),velocity:new C(...s),energy:r}}positionOf(e){let t=this.span>0?(e-this.times[0])/this.span:0;return Math.min(this.count-1,Math.max(0,t*(this.count-1)))}around(e){let[t,n]=[this.times[0],this.times[this.count-1]];if(e>=t&&e<=n)return this;let s=e>n&&e<n+(1-Bf)*this.span?n-Bf*this.span:e-Bf*this.span,r=this.span/(this.count-1);if(!(r>=Vx*Math.max(Math.abs(s),Math.abs(e))))throw new RangeError(`t must be within ${(r/Vx).toPrecision(1)} s, beyond which the points of this picture, ${r.toPrecision(2)} s apart, have hardly times of their own; got ${e}. Give a nearer time.`);let o=this.times.map((h,d)=>s+d*r),{w:a,x:l,y:c,z:u}=this.space;return new i(this.solver,o,[a,l,c,u])}},Hx=i=>i===0||i*i>Number.MIN_VALUE/Number.EPSILON&&Number.isFinite(i*i);function kf(){throw new RangeError("A number leaves double precision on the way to the picture. Give numbers, in SI units, that are nearer to one.")}function XC(i,e){let t=VC*2*Math.PI/e,n=i.period??i.nutationPeriod??null;return n!==null&&Number.isFinite(n)?Math.max(t,Math.min(2.2*n,12*t)):t}var $C=3,Va=i=>document.getElementById(i),$u=class{constructor(e,t){this.kind=zx[e.solver],this.given=e,this.changed=t,this.setting=this.first=this.kind.from(e),this.solver=this.kind.make(this.setting);let n={first:Va("controls"),more:Va("more"),fold:Va("folded")};this.controls=new fu(n,(s,r)=>this.move(s,r),s=>this.say(s)),this.show()}motion(e=null,t=null){return new Xu(this.solver,e,t)}get event(){return this.kind.event?.(this.setting,this.solver)??null}show(){let e=this.kind.controls(this.setting);this.controls.show(e,this.kind.first??e.slice(0,$C).map(({key:t})=>t)),$g(Va("facts"),this.kind.facts(this.setting,this.solver))}take(e){let t=[this.solver,this.setting];try{this.solver=this.kind.make(e)}catch(s){return this.refuse(s)}this.say("");let n=String(e.moments)!==String(this.first.moments);this.setting=e;try{this.show(),this.changed(n)}catch(s){return[this.solver,this.setting]=t,this.show(),this.changed(String(this.setting.moments)!==String(this.first.moments)),this.refuse(s)}return!0}refuse(e){let t=e instanceof RangeError,{message:n}=t?e:new RangeError(`The page cannot draw this setting (${e.message}). Take numbers that are nearer to one.`);return this.say(n),!1}move(e,t){if(e===null)return this.show();try{return this.take(this.kind.changed(this.setting,e,t))}catch(n){return this.refuse(n)}}set(e){try{return YC(e,this.kind.keys),this.take(this.kind.withSpec(this.setting,e))}catch(t){return this.refuse(t)}}point(e){this.take(this.kind.withDirection(this.setting,e))}get isAsGiven(){return this.setting===this.first}reset(){this.take(this.first)}say(e){Va("refused").textContent=e}get tables(){return this.isAsGiven?{}:this.kind.asSpec(this.setting)}toml(e){return Vg(()=>this.kind.toml?.(this.setting,e)??null)}};function YC(i,e){if(typeof i!="object"||i===null||Array.isArray(i))throw new RangeError("set takes tables like {spin: {rate: 12}}.");for(let[t,n]of Object.entries(i)){let s=Ch(e,t,"table");if(typeof n!="object"||n===null||Array.isArray(n))throw new RangeError(`${t} must be a table of keys and values, like ${t}.${Object.keys(s)[0]}; got ${Tn(n)}.`);for(let[r,o]of Object.entries(n)){let a=Ch(s,r,"key",`${t}.`),l=[o].flat();if(!(a===0?typeof o=="string":l.length===a&&Array.isArray(o)===a>1)||a&&!l.every(Rh)){let u=a===0?"a word":a===1?`a number, ${tl}`:`${a} numbers in a list, each ${tl}`;throw new RangeError(`${t}.${r} must be ${u}; got ${Tn(o)}. Check the number, which is in SI units.`)}}}}var Wx={languages:["de","es","fr"],table:{Language:["Sprache","Idioma","Langue"],"polhode: a playground":["polhode: ein Spielplatz","polhode: un campo de pruebas","polhode\xA0: un terrain de jeu"],"Motions to play with":["Bewegungen zum Ausprobieren","Movimientos para probar","Mouvements \xE0 essayer"],"Light or dark":["Hell oder dunkel","Claro u oscuro","Clair ou sombre"],"What to watch":["Was es zu sehen gibt","Qu\xE9 observar","Ce qu'il faut observer"],"What you can set":["Was sich einstellen l\xE4sst","Lo que se puede ajustar","Ce que l'on peut r\xE9gler"],"More to set":["Mehr einstellen","M\xE1s ajustes","Plus de r\xE9glages"],"Back to the start":["Zur\xFCck zum Anfang","Volver al inicio","Revenir au d\xE9part"],"Share and save":["Teilen und speichern","Compartir y guardar","Partager et enregistrer"],"Copy link":["Link kopieren","Copiar enlace","Copier le lien"],"Copy embed code":["Einbettungscode kopieren","Copiar c\xF3digo para insertar","Copier le code d'int\xE9gration"],"Copy spec":["Spezifikation kopieren","Copiar especificaci\xF3n","Copier la sp\xE9cification"],"Save picture":["Bild speichern","Guardar imagen","Enregistrer l'image"],"Save film":["Film speichern","Guardar pel\xEDcula","Enregistrer un film"],Stop:["Anhalten","Detener","Arr\xEAter"],of:["von","de","de"],"Length of the film [s]":["L\xE4nge des Films [s]","Duraci\xF3n de la pel\xEDcula [s]","Dur\xE9e du film [s]"],"The text to copy":["Der Text zum Kopieren","El texto que se copia","Le texte \xE0 copier"],"The large picture as it is now":["Das gro\xDFe Bild, wie es jetzt ist","La imagen grande tal como est\xE1 ahora","La grande image telle qu'elle est maintenant"],"Values at this time":["Werte zu dieser Zeit","Valores en este instante","Valeurs \xE0 cet instant"],"Over time":["Zeitverlauf","Evoluci\xF3n temporal","Au cours du temps"],"Made by polhode. Space: play or pause. Arrow keys: step. Home, End: ends. L: loop. + and \u2212: speed. Drag the large picture, or give it the focus and use arrow keys, to turn all views. Two fingers, or Ctrl and the wheel: closer; a click lets the wheel alone do it, until Escape or a click elsewhere.":["Erzeugt von polhode. Leertaste: abspielen oder anhalten. Pfeiltasten: ein Schritt. Pos1, Ende: Anfang und Ende. L: Schleife. + und \u2212: Tempo. Das gro\xDFe Bild ziehen, oder es fokussieren und Pfeiltasten dr\xFCcken, dreht alle Ansichten. Zwei Finger, oder Strg und Mausrad: n\xE4her heran; nach einem Klick gen\xFCgt das Mausrad, bis Escape oder ein Klick daneben folgt.","Hecho por polhode. Espacio: reproducir o pausar. Flechas: un paso. Inicio, Fin: los extremos. L: bucle. + y \u2212: velocidad. Arrastrar la imagen grande, o darle el foco y usar las flechas, gira todas las vistas. Dos dedos, o Ctrl y la rueda: m\xE1s cerca; tras un clic basta la rueda, hasta Escape o un clic fuera.","Produit par polhode. Espace\xA0: lecture ou pause. Fl\xE8ches\xA0: un pas. D\xE9but, Fin\xA0: les extr\xE9mit\xE9s. L\xA0: boucle. + et \u2212\xA0: vitesse. Faire glisser la grande image, ou lui donner le focus et utiliser les fl\xE8ches, tourne toutes les vues. Deux doigts, ou Ctrl et la molette\xA0: plus pr\xE8s\xA0; apr\xE8s un clic la molette seule suffit, jusqu'\xE0 \xC9chap ou un clic ailleurs."],Time:["Zeit","Tiempo","Temps"],"One step back":["Ein Schritt zur\xFCck","Un paso atr\xE1s","Un pas en arri\xE8re"],"One step back (\u2190)":["Ein Schritt zur\xFCck (\u2190)","Un paso atr\xE1s (\u2190)","Un pas en arri\xE8re (\u2190)"],"One step forward":["Ein Schritt vor","Un paso adelante","Un pas en avant"],"One step forward (\u2192)":["Ein Schritt vor (\u2192)","Un paso adelante (\u2192)","Un pas en avant (\u2192)"],Play:["Abspielen","Reproducir","Lecture"],Pause:["Anhalten","Pausa","Pause"],"Play or pause (space)":["Abspielen oder anhalten (Leertaste)","Reproducir o pausar (espacio)","Lecture ou pause (espace)"],Loop:["Schleife","Bucle","Boucle"],"Loop (l)":["Schleife (l)","Bucle (l)","Boucle (l)"],Slower:["Langsamer","M\xE1s lento","Plus lent"],"Slower (\u2212)":["Langsamer (\u2212)","M\xE1s lento (\u2212)","Plus lent (\u2212)"],Faster:["Schneller","M\xE1s r\xE1pido","Plus vite"],"Faster (+)":["Schneller (+)","M\xE1s r\xE1pido (+)","Plus vite (+)"],Speed:["Tempo","Velocidad","Vitesse"],"real time":["Echtzeit","tiempo real","temps r\xE9el"],yr:["a","a","an"],d:["d","d","j"],rpm:["U/min","rpm","tr/min"],"{number} rpm":["{number} U/min","{number} rpm","{number} tr/min"],"{least} to {most}":["{least} bis {most}","de {least} a {most}","de {least} \xE0 {most}"],"The wheel zooms. Esc lets go.":["Das Mausrad zoomt. Esc l\xE4sst los.","La rueda ampl\xEDa. Esc suelta.","La molette zoome. \xC9chap rel\xE2che."],"Make large: {picture}":["Vergr\xF6\xDFern: {picture}","Agrandar: {picture}","Agrandir\xA0: {picture}"],"Arrow keys turn the view, page up and down bring it closer.":["Pfeiltasten drehen die Ansicht, Bild auf und Bild ab zoomen.","Las flechas giran la vista, ReP\xE1g y AvP\xE1g la acercan o alejan.","Les fl\xE8ches tournent la vue, page pr\xE9c\xE9dente et page suivante zooment."],"show {part}":["{part} zeigen","mostrar: {part}","montrer\xA0: {part}"],"Set on this page.":["Auf dieser Seite eingestellt.","Ajustado en esta p\xE1gina.","R\xE9gl\xE9 sur cette page."],"Show it":["Zeigen","Mostrarlo","Le montrer"],"The playground has no motion called {named}; it has {keys}.":["Der Spielplatz hat keine Bewegung namens {named}; er hat {keys}.","El campo de pruebas no tiene ning\xFAn movimiento llamado {named}; tiene {keys}.","Le terrain de jeu n'a pas de mouvement nomm\xE9 {named}\xA0; il a {keys}."],"The pictures cannot be drawn ({why}). They need a browser with WebGL 2.":["Die Bilder lassen sich nicht zeichnen ({why}). Sie brauchen einen Browser mit WebGL 2.","No se pueden dibujar las im\xE1genes ({why}). Necesitan un navegador con WebGL 2.","Les images ne peuvent pas \xEAtre dessin\xE9es ({why}). Il leur faut un navigateur avec WebGL 2."],"A number is needed.":["Hier muss eine Zahl stehen.","Hace falta un n\xFAmero.","Il faut un nombre."],"It must be greater than zero.":["Sie muss gr\xF6\xDFer als null sein.","Debe ser mayor que cero.","Il doit \xEAtre sup\xE9rieur \xE0 z\xE9ro."],"No body has this moment with the two others: {least} to {most} {unit}.":["Kein K\xF6rper hat dieses Tr\xE4gheitsmoment zusammen mit den beiden anderen: {least} bis {most} {unit}.","Ning\xFAn cuerpo tiene este momento de inercia con los otros dos: de {least} a {most} {unit}.","Aucun corps n'a ce moment d'inertie avec les deux autres\xA0: de {least} \xE0 {most} {unit}."],"This browser keeps the clipboard from pages in frames: copy the text from the field below.":["Dieser Browser verwehrt Seiten in Rahmen die Zwischenablage: Bitte den Text aus dem Feld unten kopieren.","Este navegador niega el portapapeles a las p\xE1ginas en marcos: copie el texto del campo de abajo.","Ce navigateur refuse le presse-papiers aux pages dans un cadre\xA0: copiez le texte du champ ci-dessous."],"A page in a notebook has no address of its own. Write it to a file with write_page, and add this to the file's address.":["Eine Seite in einem Notebook hat keine eigene Adresse. Schreiben Sie sie mit write_page in eine Datei und h\xE4ngen Sie dies an deren Adresse an.","Una p\xE1gina en un cuaderno no tiene direcci\xF3n propia. Escr\xEDbala en un archivo con write_page y a\xF1ada esto a la direcci\xF3n del archivo.","Une page dans un notebook n'a pas d'adresse propre. \xC9crivez-la dans un fichier avec write_page, et ajoutez ceci \xE0 l'adresse du fichier."],"The link is copied.":["Der Link ist kopiert.","El enlace est\xE1 copiado.","Le lien est copi\xE9."],"The link is copied. It opens on this computer only: put the file on a web server to give it to others.":["Der Link ist kopiert. Er \xF6ffnet sich nur auf diesem Rechner: Legen Sie die Datei auf einen Webserver, um ihn weiterzugeben.","El enlace est\xE1 copiado. Solo se abre en este ordenador: ponga el archivo en un servidor web para darlo a otros.","Le lien est copi\xE9. Il ne s'ouvre que sur cet ordinateur\xA0: placez le fichier sur un serveur web pour le donner \xE0 d'autres."],"A page in a notebook has no address that another page could embed. Write it to a file with write_page, and put the file on a web server.":["Eine Seite in einem Notebook hat keine Adresse, die eine andere Seite einbetten k\xF6nnte. Schreiben Sie sie mit write_page in eine Datei, und legen Sie diese auf einen Webserver.","Una p\xE1gina en un cuaderno no tiene una direcci\xF3n que otra p\xE1gina pueda insertar. Escr\xEDbala en un archivo con write_page y ponga el archivo en un servidor web.","Une page dans un notebook n'a pas d'adresse qu'une autre page pourrait int\xE9grer. \xC9crivez-la dans un fichier avec write_page, et placez-le sur un serveur web."],"The code is copied: paste it into the HTML of a page.":["Der Code ist kopiert: F\xFCgen Sie ihn in das HTML einer Seite ein.","El c\xF3digo est\xE1 copiado: p\xE9guelo en el HTML de una p\xE1gina.","Le code est copi\xE9\xA0: collez-le dans le HTML d'une page."],"No spec says this start. A gyrostat needs its rotor's moment, and a free rotor a principal axis; a disk must begin in steady rolling.":["Keine Spezifikation beschreibt diesen Anfang. Ein Gyrostat braucht das Tr\xE4gheitsmoment seines Rotors, und ein freier Rotor eine Hauptachse; eine Scheibe muss mit station\xE4rem Rollen beginnen.","Ninguna especificaci\xF3n describe este inicio. Un girostato necesita el momento de inercia de su rotor, y un rotor libre un eje principal; un disco debe empezar rodando de forma estacionaria.","Aucune sp\xE9cification ne d\xE9crit ce d\xE9part. Un gyrostat demande le moment d'inertie de son rotor, et un rotor libre un axe principal\xA0; un disque doit commencer par un roulement stationnaire."],"The spec is copied: paste it into a file, and run polhode report on it.":["Die Spezifikation ist kopiert: F\xFCgen Sie sie in eine Datei ein, und f\xFChren Sie polhode report damit aus.","La especificaci\xF3n est\xE1 copiada: p\xE9guela en un archivo y ejecute polhode report con \xE9l.","La sp\xE9cification est copi\xE9e\xA0: collez-la dans un fichier, et lancez polhode report dessus."],"A frame like this one may not save files: save the picture below by a right click, or by a long press.":["Ein Rahmen wie dieser darf keine Dateien speichern: Sichern Sie das Bild unten durch einen Rechtsklick oder langes Dr\xFCcken.","Un marco como este no puede guardar archivos: guarde la imagen de abajo con un clic derecho o una pulsaci\xF3n larga.","Un cadre comme celui-ci ne peut pas enregistrer de fichiers\xA0: enregistrez l'image ci-dessous par un clic droit ou un appui long."],"The picture is saved.":["Das Bild ist gespeichert.","La imagen est\xE1 guardada.","L'image est enregistr\xE9e."],"This browser cannot record films: it has no MediaRecorder for canvases. Firefox and Chromium have.":["Dieser Browser kann keine Filme aufnehmen: Er hat keinen MediaRecorder f\xFCr Zeichenfl\xE4chen. Firefox und Chromium haben ihn.","Este navegador no puede grabar pel\xEDculas: no tiene MediaRecorder para lienzos. Firefox y Chromium lo tienen.","Ce navigateur ne peut pas enregistrer de films\xA0: il n'a pas de MediaRecorder pour les canevas. Firefox et Chromium en ont un."],"Recording: {passed} of {seconds} s.":["Aufnahme: {passed} von {seconds} s.","Grabando: {passed} de {seconds} s.","Enregistrement\xA0: {passed} sur {seconds} s."],"The browser has recorded nothing.":["Der Browser hat nichts aufgenommen.","El navegador no ha grabado nada.","Le navigateur n'a rien enregistr\xE9."],"The film is recorded. If it was not saved, this frame may not save files: open the page on its own.":["Der Film ist aufgenommen. Wurde er nicht gespeichert, darf dieser Rahmen keine Dateien speichern: \xD6ffnen Sie die Seite f\xFCr sich.","La pel\xEDcula est\xE1 grabada. Si no se ha guardado, este marco no puede guardar archivos: abra la p\xE1gina por s\xED sola.","Le film est enregistr\xE9. S'il n'a pas \xE9t\xE9 sauvegard\xE9, ce cadre ne peut pas \xE9crire de fichiers\xA0: ouvrez la page seule."],"The film is saved.":["Der Film ist gespeichert.","La pel\xEDcula est\xE1 guardada.","Le film est enregistr\xE9."],nothing:["nichts","nada","rien"],"A film takes {least} to {most} s; got {got}. Type a number between these.":["Ein Film dauert {least} bis {most} s; eingegeben ist {got}. Geben Sie eine Zahl dazwischen ein.","Una pel\xEDcula dura de {least} a {most} s; se ha dado {got}. Escriba un n\xFAmero entre ambos.","Un film dure de {least} \xE0 {most} s\xA0; re\xE7u\xA0: {got}. Tapez un nombre entre ces deux valeurs."],"The body in space":["Der K\xF6rper im Raum","El cuerpo en el espacio","Le corps dans l'espace"],"L points up":["L zeigt nach oben","L apunta hacia arriba","L pointe vers le haut"],"box or ellipsoid of the same inertia":["Quader oder Ellipsoid gleicher Tr\xE4gheit","paralelep\xEDpedo o elipsoide de la misma inercia","pav\xE9 ou ellipso\xEFde de m\xEAme inertie"],"box of the same inertia":["Quader gleicher Tr\xE4gheit","paralelep\xEDpedo de la misma inercia","pav\xE9 de m\xEAme inertie"],"ellipsoid of the same inertia":["Ellipsoid gleicher Tr\xE4gheit","elipsoide de la misma inercia","ellipso\xEFde de m\xEAme inertie"],"inertia ellipsoid, as no solid body has these moments":["Tr\xE4gheitsellipsoid, da kein K\xF6rper diese Momente hat","elipsoide de inercia: ning\xFAn s\xF3lido tiene estos momentos","ellipso\xEFde d'inertie, car aucun solide n'a ces moments"],"axes only, as nothing is known of the body's shape":["nur die Achsen, da die Gestalt des K\xF6rpers unbekannt ist","solo los ejes, pues no se conoce la forma del cuerpo","les axes seuls, car la forme du corps est inconnue"],"its mesh, coarsened":["sein Netz, vergr\xF6bert","su malla, simplificada","son maillage, simplifi\xE9"],"disk on a stem, of the same inertia about the pivot":["Scheibe auf einem Stiel, mit gleicher Tr\xE4gheit um den St\xFCtzpunkt","disco sobre un v\xE1stago, con la misma inercia respecto al pivote","disque sur une tige, de m\xEAme inertie autour du pivot"],"trace of axis {axis}":["Spur der Achse {axis}","traza del eje {axis}","trace de l'axe {axis}"],"trace of the axis through the centre of mass":["Spur der Achse durch den Schwerpunkt","traza del eje por el centro de masas","trace de l'axe passant par le centre de masse"],"weight mg":["Gewicht mg","peso mg","poids mg"],"torque of the weight, dL/dt":["Drehmoment des Gewichts, dL/dt","momento del peso, dL/dt","moment du poids, dL/dt"],"cone of \u03A9 in space":["Kegel von \u03A9 im Raum","cono de \u03A9 en el espacio","c\xF4ne de \u03A9 dans l'espace"],"cone of \u03A9 about L (space cone)":["Kegel von \u03A9 um L (Rastpolkegel)","cono de \u03A9 en torno a L (cono espacial)","c\xF4ne de \u03A9 autour de L (c\xF4ne de base)"],"cone of \u03A9 in the body":["Kegel von \u03A9 im K\xF6rper (Gangpolkegel)","cono de \u03A9 en el cuerpo (cono del cuerpo)","c\xF4ne de \u03A9 dans le corps (c\xF4ne roulant)"],"cone of the axis":["Kegel der Achse","cono del eje","c\xF4ne de l'axe"],"rotor, drawn at rest: its moment is not given":["Rotor, ruhend gezeichnet: sein Tr\xE4gheitsmoment ist nicht angegeben","rotor, dibujado en reposo: no se da su momento","rotor, dessin\xE9 au repos\xA0: son moment n'est pas donn\xE9"],"rotor, {rate} against the body":["Rotor, {rate} gegen den K\xF6rper","rotor, {rate} respecto al cuerpo","rotor, {rate} par rapport au corps"],"Path of the axis":["Bahn der Achse","Trayectoria del eje","Trajectoire de l'axe"],"from the pivot towards the centre of mass":["vom St\xFCtzpunkt zum Schwerpunkt","del pivote hacia el centro de masas","du pivot vers le centre de masse"],"third principal axis":["dritte Hauptachse","tercer eje principal","troisi\xE8me axe principal"],axis:["Achse","eje","axe"],"limits of its tilt":["Grenzen ihrer Neigung","l\xEDmites de su inclinaci\xF3n","limites de son inclinaison"],up:["oben","arriba","haut"],"Poinsot's ellipsoid":["Poinsot-Ellipsoid","Elipsoide de Poinsot","Ellipso\xEFde de Poinsot"],"rolls without slipping on the plane across L":["rollt ohne Gleiten auf der Ebene senkrecht zu L","rueda sin deslizar sobre el plano perpendicular a L","roule sans glisser sur le plan perpendiculaire \xE0 L"],"at rest":["in Ruhe","en reposo","au repos"],polhode:["Polhodie","polhodia","polhodie"],herpolhode:["Herpolhodie","herpolhodia","herpolhodie"],"contact, \u2212\u03A9":["Ber\xFChrpunkt, \u2212\u03A9","contacto, \u2212\u03A9","contact, \u2212\u03A9"],"Momentum sphere":["Drehimpulskugel","Esfera del momento angular","Sph\xE8re du moment cin\xE9tique"],"L in body axes runs along its polhode":["L l\xE4uft in k\xF6rperfesten Achsen entlang seiner Polhodie","L, en los ejes del cuerpo, recorre su polhodia","L, dans les axes du corps, parcourt sa polhodie"],"L in body axes runs along its polhode; dots are the log's samples":["L l\xE4uft in k\xF6rperfesten Achsen entlang seiner Polhodie; Punkte sind die Messwerte","L, en los ejes del cuerpo, recorre su polhodia; los puntos son las medidas","L, dans les axes du corps, parcourt sa polhodie\xA0; les points sont les mesures"],"direction of L in body axes":["Richtung von L in k\xF6rperfesten Achsen","direcci\xF3n de L en los ejes del cuerpo","direction de L dans les axes du corps"],"direction of L in body axes; levels are those at the end":["Richtung von L in k\xF6rperfesten Achsen; Niveaulinien f\xFCr das Ende","direcci\xF3n de L en los ejes del cuerpo; los niveles son los del final","direction de L dans les axes du corps\xA0; niveaux \xE0 la fin"],"other polhodes":["andere Polhodien","otras polhodias","autres polhodies"],"levels of energy":["Niveaulinien der Energie","niveles de energ\xEDa","niveaux d'\xE9nergie"],"this motion":["diese Bewegung","este movimiento","ce mouvement"],measured:["gemessen","medido","mesur\xE9"],separatrix:["Separatrix","separatriz","s\xE9paratrice"],stable:["stabil","estable","stable"],unstable:["instabil","inestable","instable"],undecided:["unentschieden","indeciso","ind\xE9cis"],"ellipsoid of the same energy":["Ellipsoid gleicher Energie","elipsoide de la misma energ\xEDa","ellipso\xEFde de m\xEAme \xE9nergie"],"Levels of J = {J} as polhodes":["Niveaus von J = {J} als Polhodien","Niveles de J = {J} como polhodias","Niveaux de J = {J} en polhodies"],"drag the point to another level, or L":["den Punkt auf ein anderes Niveau ziehen, oder L","arrastre el punto a otro nivel, o L","faites glisser le point vers un autre niveau, ou L"],"levels round {axis}":["Niveaus um {axis}","niveles en torno a {axis}","niveaux autour de {axis}"],"Wigner function":["Wigner-Funktion","Funci\xF3n de Wigner","Fonction de Wigner"],"of the quantum state, and classical bodies that began as it did":["des Quantenzustands, mit klassischen K\xF6rpern, die wie er begannen","del estado cu\xE1ntico, con cuerpos cl\xE1sicos que empezaron igual","de l'\xE9tat quantique, et corps classiques partis comme lui"],"of the level {level}, and its polhodes":["des Niveaus {level}, mit seinen Polhodien","del nivel {level}, y sus polhodias","du niveau {level}, et ses polhodies"],negative:["negativ","negativo","n\xE9gatif"],positive:["positiv","positivo","positif"],"classical L":["klassisches L","L cl\xE1sico","L classique"],"The rolling disk":["Die rollende Scheibe","El disco rodante","Le disque roulant"],"with the path of its contact":["mit der Bahn ihres Ber\xFChrpunkts","con la trayectoria de su contacto","avec la trajectoire de son contact"],contact:["Ber\xFChrpunkt","contacto","contact"],"below the centre":["unter dem Mittelpunkt","bajo el centro","sous le centre"],"sound of the contact":["Klang des Ber\xFChrpunkts","sonido del contacto","son du contact"],"Point vortices":["Punktwirbel","V\xF3rtices puntuales","Tourbillons ponctuels"],"in the plane, from above":["in der Ebene, von oben","en el plano, desde arriba","dans le plan, vu de dessus"],"on the sphere":["auf der Kugel","sobre la esfera","sur la sph\xE8re"],anticlockwise:["gegen den Uhrzeigersinn","antihorario","sens antihoraire"],clockwise:["im Uhrzeigersinn","horario","sens horaire"],Vorticity:["Wirbelst\xE4rke","Vorticidad","Vorticit\xE9"],"of the fluid against the sphere":["des Fluids gegen die Kugel","del fluido respecto a la esfera","du fluide par rapport \xE0 la sph\xE8re"],"against the sphere, with lines of the field":["gegen die Kugel, mit Feldlinien","respecto a la esfera, con l\xEDneas de campo","par rapport \xE0 la sph\xE8re, avec les lignes de champ"],Current:["Strom","Corriente","Courant"],"through the sphere, with lines of the field":["durch die Kugel, mit Feldlinien","a trav\xE9s de la esfera, con l\xEDneas de campo","\xE0 travers la sph\xE8re, avec les lignes de champ"],inward:["einw\xE4rts","entrante","entrant"],outward:["ausw\xE4rts","saliente","sortant"],Spins:["Spins","Espines","Spins"],"from above, red towards the reader":["von oben, rot zum Betrachter hin","desde arriba, rojo hacia el lector","vu de dessus, rouge vers le lecteur"],"towards the reader":["zum Betrachter hin","hacia el lector","vers le lecteur"],away:["vom Betrachter weg","alej\xE1ndose","en s'\xE9loignant"],"Spin on the orbit":["Drehung auf der Bahn","Giro en la \xF3rbita","Rotation sur l'orbite"],"seen from above; the moon is drawn large":["von oben gesehen; der Mond ist vergr\xF6\xDFert","vista desde arriba; la luna est\xE1 ampliada","vu de dessus\xA0; la lune est agrandie"],"long axis":["lange Achse","eje largo","grand axe"],planet:["Planet","planeta","plan\xE8te"],"Phase space":["Phasenraum","Espacio de fases","Espace des phases"],"position to the right, velocity upwards":["Ort nach rechts, Geschwindigkeit nach oben","posici\xF3n a la derecha, velocidad hacia arriba","position vers la droite, vitesse vers le haut"],"many electrons":["viele Elektronen","muchos electrones","beaucoup d'\xE9lectrons"],few:["wenige","pocos","peu"],"\u03A9 along the body's axes":["\u03A9 entlang der K\xF6rperachsen","\u03A9 seg\xFAn los ejes del cuerpo","\u03A9 selon les axes du corps"],"L along the body's axes":["L entlang der K\xF6rperachsen","L seg\xFAn los ejes del cuerpo","L selon les axes du corps"],"angles of the axes from L":["Winkel der Achsen gegen L","\xE1ngulos de los ejes con L","angles des axes avec L"],"tilt of the axis from the vertical":["Neigung der Achse gegen die Senkrechte","inclinaci\xF3n del eje respecto a la vertical","inclinaison de l'axe par rapport \xE0 la verticale"],tilt:["Neigung","inclinaci\xF3n","inclinaison"],"axis 1":["Achse 1","eje 1","axe 1"],"axis 2":["Achse 2","eje 2","axe 2"],"axis 3":["Achse 3","eje 3","axe 3"],"axis {axis}":["Achse {axis}","eje {axis}","axe {axis}"],"the polhode from above, {across} across: the sphere magnified {times} times":["die Polhodie von oben, {across} breit: die Kugel {times}-fach vergr\xF6\xDFert","la polhodia desde arriba, {across} de ancho: la esfera ampliada {times} veces","la polhodie vue de dessus, large de {across}\xA0: la sph\xE8re grossie {times} fois"],"with the point that moves":["mit dem bewegten Punkt","con el punto que se mueve","avec le point mobile"],"over time":["im Zeitverlauf","a lo largo del tiempo","au cours du temps"],"L along the b axis, in |L|":["L entlang der b-Achse, in |L|","L seg\xFAn el eje b, en |L|","L selon l'axe b, en |L|"],"quantum \u27E8L\u27E9":["quantenmechanisches \u27E8L\u27E9","\u27E8L\u27E9 cu\xE1ntico","\u27E8L\u27E9 quantique"],"one classical body":["ein klassischer K\xF6rper","un cuerpo cl\xE1sico","un corps classique"],"mean of classical bodies":["Mittel klassischer K\xF6rper","media de cuerpos cl\xE1sicos","moyenne de corps classiques"],"quantum \u27E8L\u27E9 along the axes, in J":["quantenmechanisches \u27E8L\u27E9 entlang der Achsen, in J","\u27E8L\u27E9 cu\xE1ntico seg\xFAn los ejes, en J","\u27E8L\u27E9 quantique selon les axes, en J"],Tilt:["Neigung","Inclinaci\xF3n","Inclinaison"],Precession:["Pr\xE4zession","Precesi\xF3n","Pr\xE9cession"],"the whole motion: log\u2081\u2080 {unit} against log\u2081\u2080 of the time left [s], which runs to the left":["die ganze Bewegung: log\u2081\u2080 {unit} gegen log\u2081\u2080 der verbleibenden Zeit [s], die nach links l\xE4uft","todo el movimiento: log\u2081\u2080 {unit} frente a log\u2081\u2080 del tiempo restante [s], que va hacia la izquierda","tout le mouvement\xA0: log\u2081\u2080 {unit} en fonction du log\u2081\u2080 du temps restant [s], qui va vers la gauche"],"energy in eddies":["Energie in Wirbeln","energ\xEDa en remolinos","\xE9nergie dans les tourbillons"],"of all":["vom Ganzen","del total","du total"],"up to degree {degree}":["bis zum Grad {degree}","hasta el grado {degree}","jusqu'au degr\xE9 {degree}"],energy:["Energie","energ\xEDa","\xE9nergie"],kinetic:["kinetisch","cin\xE9tica","cin\xE9tique"],magnetic:["magnetisch","magn\xE9tica","magn\xE9tique"],magnetisation:["Magnetisierung","magnetizaci\xF3n","aimantation"],"of the largest":["der gr\xF6\xDFten","de la mayor","de la plus grande"],field:["Feld","campo","champ"],"wave {number}":["Welle {number}","onda {number}","onde {number}"],latitude:["Breite","latitud","latitude"],longitude:["L\xE4nge","longitud","longitude"],"angle of the long axis, half turns taken off":["Winkel der langen Achse, ohne halbe Umdrehungen","\xE1ngulo del eje largo, sin medias vueltas","angle du grand axe, demi-tours retir\xE9s"],angle:["Winkel","\xE1ngulo","angle"],rate:["Drehrate","velocidad angular","vitesse angulaire"],"turns per orbit":["Umdrehungen je Umlauf","vueltas por \xF3rbita","tours par orbite"],"distance to a twin that starts 10\u207B\u2076 rad apart":["Abstand von einem Zwilling, der 10\u207B\u2076 rad daneben beginnt","distancia a un gemelo que empieza a 10\u207B\u2076 rad","distance \xE0 un jumeau parti \xE0 10\u207B\u2076 rad"],distance:["Abstand","distancia","distance"],"Section at periapsis":["Schnitt im Perizentrum","Secci\xF3n en el periapsis","Section au p\xE9riastre"],"{count} orbits: \u03B8\u0307/n against \u03B8 [\xB0]":["{count} Uml\xE4ufe: \u03B8\u0307/n gegen \u03B8 [\xB0]","{count} \xF3rbitas: \u03B8\u0307/n frente a \u03B8 [\xB0]","{count} orbites\xA0: \u03B8\u0307/n en fonction de \u03B8 [\xB0]"],"largest drift":["gr\xF6\xDFte Drift","mayor deriva","plus grande d\xE9rive"],"L in space":["L im Raum","L en el espacio","L dans l'espace"],"vertical momentum":["Drehimpuls um die Senkrechte","momento angular vertical","moment cin\xE9tique vertical"],"axial momentum":["Drehimpuls um die Achse","momento angular axial","moment cin\xE9tique axial"],"what it does":["was er tut","qu\xE9 hace","ce qu'il fait"],"keeps |L|":["beh\xE4lt |L|","conserva |L|","conserve |L|"],"loses energy and ends spinning about its axis of largest moment":["verliert Energie und dreht am Ende um die Achse des gr\xF6\xDFten Tr\xE4gheitsmoments","pierde energ\xEDa y acaba girando en torno al eje de mayor momento de inercia","perd de l'\xE9nergie et finit par tourner autour de l'axe de plus grand moment d'inertie"],"losses inside, \u03B1":["innere Verluste, \u03B1","p\xE9rdidas internas, \u03B1","pertes internes, \u03B1"],"energy it can lose inside":["Energie, die er innen verlieren kann","energ\xEDa que puede perder internamente","\xE9nergie qu'il peut perdre en interne"],"within 5\xB0 of the flat spin after":["bis auf 5\xB0 im flachen Drehen nach","a menos de 5\xB0 del giro plano tras","\xE0 moins de 5\xB0 de la rotation \xE0 plat apr\xE8s"],"set the body by":["K\xF6rper einstellen durch","definir el cuerpo por","d\xE9finir le corps par"],"its moments":["seine Tr\xE4gheitsmomente","sus momentos de inercia","ses moments d'inertie"],"the edges of a box":["die Kanten eines Quaders","las aristas de un paralelep\xEDpedo","les ar\xEAtes d'un pav\xE9"],"mass of the box":["Masse des Quaders","masa del paralelep\xEDpedo","masse du pav\xE9"],"edge along axis {axis}":["Kante entlang Achse {axis}","arista seg\xFAn el eje {axis}","ar\xEAte selon l'axe {axis}"],"moment of inertia I{axis}":["Tr\xE4gheits\xADmoment I{axis}","momento de inercia I{axis}","moment d'inertie I{axis}"],"spin rate |\u03A9|":["Drehrate |\u03A9|","velocidad de giro |\u03A9|","vitesse de rotation |\u03A9|"],"tilt counted from":["Neigung gez\xE4hlt von","inclinaci\xF3n contada desde","inclinaison compt\xE9e depuis"],"tilt of the spin":["Neigung der Drehung","inclinaci\xF3n del giro","inclinaison de la rotation"],"tilted towards (0\xB0 is axis {axis})":["geneigt zu (0\xB0 ist Achse {axis})","inclinado hacia (0\xB0 es el eje {axis})","inclin\xE9e vers (0\xB0\xA0: axe {axis})"],"period of L in the body":["Periode von L im K\xF6rper","per\xEDodo de L en el cuerpo","p\xE9riode de L dans le corps"],"precession about L":["Pr\xE4zession um L","precesi\xF3n en torno a L","pr\xE9cession autour de L"],"{angle} per period":["{angle} je Periode","{angle} por per\xEDodo","{angle} par p\xE9riode"],"turns over every":["kippt um alle","se da la vuelta cada","se retourne toutes les"],"turns over and over":["kippt immer wieder um","se da la vuelta una y otra vez","se retourne encore et encore"],"runs up to the intermediate axis and stays there":["l\xE4uft auf die mittlere Hauptachse zu und bleibt dort","llega al eje intermedio y se queda ah\xED","rejoint l'axe interm\xE9diaire et y reste"],"spins steadily":["dreht sich gleichf\xF6rmig","gira uniformemente","tourne uniform\xE9ment"],"cones, its axis {angle} from L":["Kegelbewegung, seine Achse {angle} von L","describe un cono, con el eje a {angle} de L","d\xE9crit un c\xF4ne, son axe \xE0 {angle} de L"],"tumbles, its axis {angle} from L":["taumelt, seine Achse {angle} von L","da tumbos, con el eje a {angle} de L","culbute, son axe \xE0 {angle} de L"],regime:["Bewegungsart","r\xE9gimen","r\xE9gime"],rest:["Ruhe","reposo","repos"],spherical:["kugelsymmetrisch","esf\xE9rico","sph\xE9rique"],permanent:["permanente Drehung","permanente","permanent"],symmetric:["symmetrischer Kreisel","sim\xE9trico","sym\xE9trique"],"short-axis":["um die kurze Achse","eje corto","petit axe"],"long-axis":["um die lange Achse","eje largo","grand axe"],"momentum of the rotor":["Drehimpuls des Rotors","momento angular del rotor","moment cin\xE9tique du rotor"],"rotor speed against the body":["Drehzahl des Rotors gegen den K\xF6rper","velocidad del rotor respecto al cuerpo","vitesse du rotor par rapport au corps"],"rotor's axis leans from L":["Neigung der Rotorachse gegen L","inclinaci\xF3n del eje del rotor sobre L","inclinaison de l'axe du rotor sur L"],"precession of the rotor's axis about L":["Pr\xE4zession der Rotorachse um L","precesi\xF3n del eje del rotor en torno a L","pr\xE9cession de l'axe du rotor autour de L"],"a spin about the rotor's axis":["eine Drehung um die Rotorachse","un giro en torno al eje del rotor","une rotation autour de l'axe du rotor"],"stable, also with losses in the body: least energy":["stabil, auch mit Verlusten im K\xF6rper: kleinste Energie","estable, tambi\xE9n con p\xE9rdidas en el cuerpo: energ\xEDa m\xEDnima","stable, m\xEAme avec des pertes dans le corps\xA0: \xE9nergie minimale"],"stable until losses act: most energy":["stabil, solange nichts verloren geht: gr\xF6\xDFte Energie","estable mientras no haya p\xE9rdidas: energ\xEDa m\xE1xima","stable tant qu'il n'y a pas de pertes\xA0: \xE9nergie maximale"],"unstable: a saddle of the energy":["instabil: ein Sattel der Energie","inestable: un punto de silla de la energ\xEDa","instable\xA0: un col de l'\xE9nergie"],"nutation: L goes round it in the body every":["Nutation: L uml\xE4uft sie im K\xF6rper alle","nutaci\xF3n: L le da la vuelta en el cuerpo cada","nutation\xA0: L en fait le tour dans le corps toutes les"],"{quantity}, change in 20 turns":["{quantity}, \xC4nderung in 20 Umdrehungen","{quantity}, cambio en 20 vueltas","{quantity}, variation en 20 tours"],"weight \xD7 distance to the centre of mass":["Gewicht \xD7 Abstand zum Schwerpunkt","peso \xD7 distancia al centro de masas","poids \xD7 distance au centre de masse"],"axis leans":["Neigung der Achse","inclinaci\xF3n del eje","inclinaison de l'axe"],"nutation: nods every":["Nutation: nickt alle","nutaci\xF3n: cabecea cada","nutation\xA0: oscille toutes les"],"mean precession":["mittlere Pr\xE4zession","precesi\xF3n media","pr\xE9cession moyenne"],"a gyroscope's, mgl/I\u2083\u03C9":["die eines Gyroskops, mgl/I\u2083\u03C9","la de un gir\xF3scopo, mgl/I\u2083\u03C9","celle d'un gyroscope, mgl/I\u2083\u03C9"],"upright at this spin, to first order":["aufrecht bei dieser Drehung, in erster Ordnung","vertical con este giro, a primer orden","debout \xE0 cette rotation, au premier ordre"],"stable: it would sleep":["stabil: er w\xFCrde schlafen","estable: dormir\xEDa","stable\xA0: elle dormirait"],"unstable: it would fall":["instabil: er w\xFCrde fallen","inestable: caer\xEDa","instable\xA0: elle tomberait"],"moment of inertia across, at the point":["Tr\xE4gheits\xADmoment quer, im St\xFCtzpunkt","momento de inercia transversal, en la punta","moment d'inertie transverse, \xE0 la pointe"],"moment of inertia about the axis":["Tr\xE4gheits\xADmoment um die Achse","momento de inercia respecto al eje","moment d'inertie autour de l'axe"],lean:["Neigung","inclinaci\xF3n","inclinaison"],"spin about its axis":["Eigendrehung","rotaci\xF3n propia","rotation propre"],"precession at the start":["Pr\xE4zession am Anfang","precesi\xF3n al inicio","pr\xE9cession au d\xE9part"],"nutation at the start":["Nutation am Anfang","nutaci\xF3n al inicio","nutation au d\xE9part"],"stands upright and spins":["steht aufrecht und dreht sich","se mantiene vertical y gira","se tient debout et tourne"],"hangs and spins":["h\xE4ngt und dreht sich","cuelga y gira","pend et tourne"],"goes round at constant lean":["pr\xE4zediert mit gleicher Neigung","precesa con inclinaci\xF3n constante","pr\xE9cesse \xE0 inclinaison constante"],"no weight: turns freely":["kein Gewicht: dreht sich frei","sin peso: gira libremente","sans poids\xA0: tourne librement"],"swings like a pendulum":["schwingt wie ein Pendel","oscila como un p\xE9ndulo","oscille comme un pendule"],"nods while it goes round, always onward":["nickt beim Pr\xE4zedieren, immer vorw\xE4rts","cabecea mientras precesa, siempre hacia delante","nute en pr\xE9cessant, toujours vers l'avant"],"nods, halting at cusps":["nickt und h\xE4lt in Spitzen an","cabecea, deteni\xE9ndose en c\xFAspides","nute, en s'arr\xEAtant aux points de rebroussement"],"nods in loops":["nickt in Schleifen","cabecea en lazos","nute en boucles"],"rises to the vertical and stays there":["richtet sich auf und bleibt aufrecht","sube a la vertical y se queda ah\xED","monte \xE0 la verticale et y reste"],"nods every":["nickt alle","cabecea cada","nute toutes les"],"sleeps upright from":["schl\xE4ft aufrecht ab","duerme vertical a partir de","dort debout \xE0 partir de"],state:["Zustand","estado","\xE9tat"],level:["Niveau","nivel","niveau"],"L as sharp as it can be":["L so scharf wie m\xF6glich","L tan definido como es posible","L aussi d\xE9fini que possible"],"L leans from the b axis by":["Neigung von L gegen die b-Achse","inclinaci\xF3n de L sobre el eje b","inclinaison de L sur l'axe b"],"towards (0\xB0 is a, 90\xB0 is c)":["in Richtung (0\xB0 ist a, 90\xB0 ist c)","hacia (0\xB0 es a, 90\xB0 es c)","vers (0\xB0\xA0: a, 90\xB0\xA0: c)"],"classical energy E/hc":["klassische Energie E/hc","energ\xEDa cl\xE1sica E/hc","\xE9nergie classique E/hc"],"classical L goes round its polhode in":["klassisches L uml\xE4uft seine Polhodie in","L cl\xE1sico recorre su polhodia en","L classique parcourt sa polhodie en"],"energy E/hc":["Energie E/hc","energ\xEDa E/hc","\xE9nergie E/hc"],"energy E/hc, rigid rotor":["Energie E/hc, starrer Rotator","energ\xEDa E/hc, rotor r\xEDgido","\xE9nergie E/hc, rotateur rigide"],"as a quantised polhode":["als quantisierte Polhodie","como polhodia cuantizada","comme polhodie quantifi\xE9e"],"L goes round":["L uml\xE4uft","L rodea","L tourne autour de"],"the a axis, above the saddle":["die a-Achse, \xFCber dem Sattel","el eje a, por encima de la silla","l'axe a, au-dessus du col"],"the c axis, below the saddle":["die c-Achse, unter dem Sattel","el eje c, por debajo de la silla","l'axe c, au-dessous du col"],"step to the next of its ladder":["Abstand zur n\xE4chsten Stufe der Leiter","paso al siguiente de su escalera","\xE9cart au niveau suivant de son \xE9chelle"],"turns of L a second, half way there":["Uml\xE4ufe von L je Sekunde, auf halbem Weg","vueltas de L por segundo, a medio camino","tours de L par seconde, \xE0 mi-chemin"],"tunnelling splits the pair by":["Tunneln spaltet das Paar um","el efecto t\xFAnel separa el par en","l'effet tunnel s\xE9pare la paire de"],"\u27E8L_b\u27E9 falls to J/2 after":["\u27E8L_b\u27E9 f\xE4llt auf J/2 nach","\u27E8L_b\u27E9 cae a J/2 tras","\u27E8L_b\u27E9 tombe \xE0 J/2 apr\xE8s"],"first reversal":["erste Umkehr","primera inversi\xF3n","premier retournement"],"{time}, to \u27E8L_b\u27E9 = {value} J":["{time}, bis \u27E8L_b\u27E9 = {value} J","{time}, hasta \u27E8L_b\u27E9 = {value} J","{time}, jusqu'\xE0 \u27E8L_b\u27E9 = {value} J"],"revival T_rev":["Wiederkehr T_rev","resurgimiento T_rev","renaissance T_rev"],"tilt of the face at first":["Neigung der Fl\xE4che am Anfang","inclinaci\xF3n de la cara al inicio","inclinaison de la face au d\xE9part"],radius:["Radius","radio","rayon"],thickness:["Dicke","espesor","\xE9paisseur"],mass:["Masse","masa","masse"],gravity:["Fall\xADbeschleunigung","gravedad","pesanteur"],"viscosity of the air":["Z\xE4higkeit der Luft","viscosidad del aire","viscosit\xE9 de l'air"],"loss in the boundary layer":["Verlust in der Grenzschicht","p\xE9rdida en la capa l\xEDmite","perte dans la couche limite"],"viscous friction of the contact":["viskose Reibung am Ber\xFChrpunkt","fricci\xF3n viscosa del contacto","frottement visqueux du contact"],"dry friction of the contact":["trockene Reibung am Ber\xFChrpunkt","fricci\xF3n seca del contacto","frottement sec du contact"],"lever arm of rolling friction":["Hebelarm der Rollreibung","brazo de la fricci\xF3n de rodadura","bras de levier du frottement de roulement"],"lever arm of drilling friction":["Hebelarm der Bohrreibung","brazo de la fricci\xF3n de pivoteo","bras de levier du frottement de pivotement"],"contact goes round every":["Ber\xFChrpunkt l\xE4uft um alle","el contacto da la vuelta cada","le contact fait le tour toutes les"],"energy at first":["Energie am Anfang","energ\xEDa al inicio","\xE9nergie au d\xE9part"],"energy less losses, change in 20 rounds":["Energie ohne Verluste, \xC4nderung in 20 Uml\xE4ufen","energ\xEDa sin p\xE9rdidas, cambio en 20 vueltas","\xE9nergie hors pertes, variation en 20 tours"],"lost in 20 rounds":["verloren in 20 Uml\xE4ufen","perdido en 20 vueltas","perdu en 20 tours"],ends:["endet","termina","se termine"],"flat on the table, within 20 rounds":["flach auf dem Tisch, binnen 20 Uml\xE4ufen","plano sobre la mesa, en menos de 20 vueltas","\xE0 plat sur la table, en moins de 20 tours"],"by {event}, within 20 rounds":["durch {event}, binnen 20 Uml\xE4ufen","por {event}, en menos de 20 vueltas","par {event}, en moins de 20 tours"],"Open a gyro log\u2026":["Gyro-Aufzeichnung \xF6ffnen\u2026","Abrir un registro de gir\xF3scopo\u2026","Ouvrir un relev\xE9 de gyroscope\u2026"],"or drop it on this page: phyphox, Sensor Logger, AndroSensor, Betaflight, or any table with a time and three angular velocities. It stays on this computer.":["oder auf diese Seite ziehen: phyphox, Sensor Logger, AndroSensor, Betaflight oder jede Tabelle mit einer Zeit und drei Winkelgeschwindigkeiten. Sie bleibt auf diesem Rechner.","o su\xE9ltelo en esta p\xE1gina: phyphox, Sensor Logger, AndroSensor, Betaflight o cualquier tabla con un tiempo y tres velocidades angulares. Se queda en este ordenador.","ou d\xE9posez-le sur cette page\xA0: phyphox, Sensor Logger, AndroSensor, Betaflight, ou toute table avec un temps et trois vitesses angulaires. Il reste sur cet ordinateur."],"A log of your own":["Eine eigene Aufzeichnung","Un registro propio","Un relev\xE9 \xE0 vous"],"Columns and units":["Spalten und Einheiten","Columnas y unidades","Colonnes et unit\xE9s"],"Read the log":["Aufzeichnung lesen","Leer el registro","Lire le relev\xE9"],"choose\u2026":["w\xE4hlen\u2026","elegir\u2026","choisir\u2026"],"fitting\u2026":["wird angepasst\u2026","ajustando\u2026","ajustement\u2026"],time:["Zeit","tiempo","temps"],"unit of the time":["Einheit der Zeit","unidad del tiempo","unit\xE9 du temps"],"angular velocity, given axes":["Winkelgeschwindigkeit, gegebene Achsen","velocidad angular, ejes dados","vitesse angulaire, axes donn\xE9s"],"pointing error":["Ausrichtungsfehler","error de apuntamiento","erreur de pointage"],"rates of the wheels":["Drehraten der R\xE4der","velocidades de las ruedas","vitesses des roues"],"angular velocity x":["Winkelgeschwindigkeit x","velocidad angular x","vitesse angulaire x"],"angular velocity y":["Winkelgeschwindigkeit y","velocidad angular y","vitesse angulaire y"],"angular velocity z":["Winkelgeschwindigkeit z","velocidad angular z","vitesse angulaire z"],"its unit":["ihre Einheit","su unidad","son unit\xE9"],"which throw":["welcher Wurf","qu\xE9 lanzamiento","quel lancer"],"column {column}":["Spalte {column}","columna {column}","colonne {column}"],"line {line}, {column}":["Zeile {line}, {column}","l\xEDnea {line}, {column}","ligne {line}, {column}"],times:["Zeiten","tiempos","temps"],rates:["Drehraten","velocidades angulares","vitesses angulaires"],accelerations:["Beschleunigungen","aceleraciones","acc\xE9l\xE9rations"],"no app that is known writes such a header. Choose what the columns are, and the units that the file does not say.":["Keine bekannte App schreibt so eine Kopfzeile. W\xE4hlen Sie, was die Spalten sind, und die Einheiten, die die Datei nicht nennt.","ninguna aplicaci\xF3n conocida escribe un encabezado as\xED. Elija qu\xE9 son las columnas y las unidades que el archivo no dice.","aucune application connue n'\xE9crit un tel en-t\xEAte. Choisissez ce que sont les colonnes, et les unit\xE9s que le fichier ne dit pas."],"it has {size} MB, and at most {most} MB are read. Cut the log to the throw.":["Sie hat {size} MB, und h\xF6chstens {most} MB werden gelesen. K\xFCrzen Sie die Aufzeichnung auf den Wurf.","tiene {size} MB, y se leen como mucho {most} MB. Recorte el registro al lanzamiento.","il a {size} Mo, et au plus {most} Mo sont lus. R\xE9duisez le relev\xE9 au lancer."],"it is a zip archive. Unpack it, and choose the table inside, like Gyroscope.csv or Raw Data.csv.":["Das ist ein ZIP-Archiv. Entpacken Sie es, und w\xE4hlen Sie die Tabelle darin, etwa Gyroscope.csv oder Raw Data.csv.","es un archivo zip. Descompr\xEDmalo y elija la tabla de dentro, como Gyroscope.csv o Raw Data.csv.","c'est une archive zip. D\xE9compressez-la, et choisissez la table qu'elle contient, comme Gyroscope.csv ou Raw Data.csv."],"no sample stands below the header in line {line}. Log again.":["Unter der Kopfzeile in Zeile {line} steht kein Messwert. Zeichnen Sie noch einmal auf.","no hay ninguna medida bajo el encabezado de la l\xEDnea {line}. Registre de nuevo.","aucune mesure sous l'en-t\xEAte de la ligne {line}. Refaites le relev\xE9."],"it is not known which columns have the time and the angular velocities: no app that is known writes such a header. Choose them.":["Es ist nicht bekannt, welche Spalten die Zeit und die Winkelgeschwindigkeiten haben: Keine bekannte App schreibt so eine Kopfzeile. W\xE4hlen Sie sie.","no se sabe qu\xE9 columnas tienen el tiempo y las velocidades angulares: ninguna aplicaci\xF3n conocida escribe un encabezado as\xED. El\xEDjalas.","on ne sait pas quelles colonnes ont le temps et les vitesses angulaires\xA0: aucune application connue n'\xE9crit un tel en-t\xEAte. Choisissez-les."],"{column} is chosen twice. Choose another column for each.":["{column} ist zweimal gew\xE4hlt. W\xE4hlen Sie f\xFCr jede Gr\xF6\xDFe eine andere Spalte.","{column} est\xE1 elegida dos veces. Elija otra columna para cada magnitud.","{column} est choisie deux fois. Choisissez une autre colonne pour chaque grandeur."],"the unit of the angular velocity is not known: the file does not say it. Choose deg/s, rad/s or rpm.":["Die Einheit der Winkelgeschwindigkeit ist nicht bekannt: Die Datei nennt sie nicht. W\xE4hlen Sie deg/s, rad/s oder rpm.","no se conoce la unidad de la velocidad angular: el archivo no la dice. Elija deg/s, rad/s o rpm.","l'unit\xE9 de la vitesse angulaire est inconnue\xA0: le fichier ne la dit pas. Choisissez deg/s, rad/s ou rpm."],"the unit of the time is not known: the file does not say it. Choose it.":["Die Einheit der Zeit ist nicht bekannt: Die Datei nennt sie nicht. W\xE4hlen Sie sie.","no se conoce la unidad del tiempo: el archivo no la dice. El\xEDjala.","l'unit\xE9 du temps est inconnue\xA0: le fichier ne la dit pas. Choisissez-la."],"a gyro log must have {least} finite samples at different times; this one has {count}. Log for longer.":["Eine Gyro-Aufzeichnung muss {least} endliche Messwerte zu verschiedenen Zeiten haben; diese hat {count}. Zeichnen Sie l\xE4nger auf.","un registro de gir\xF3scopo debe tener {least} medidas finitas en tiempos distintos; este tiene {count}. Registre m\xE1s tiempo.","un relev\xE9 de gyroscope doit avoir {least} mesures finies \xE0 des temps diff\xE9rents\xA0; celui-ci en a {count}. Enregistrez plus longtemps."],"Accelerations are left out, as their unit is not known.":["Beschleunigungen bleiben weg, da ihre Einheit nicht bekannt ist.","Se omiten las aceleraciones, pues no se conoce su unidad.","Les acc\xE9l\xE9rations sont omises, car leur unit\xE9 est inconnue."],"{count} lines without finite values are left out.":["{count} Zeilen ohne endliche Werte bleiben weg.","Se omiten {count} l\xEDneas sin valores finitos.","{count} lignes sans valeurs finies sont omises."],"times of {what} must lie {least} s apart or more; got {got} s. Check which column has the times, and their unit.":["Zeiten der {what} m\xFCssen {least} s oder mehr auseinander liegen; hier sind es {got} s. Pr\xFCfen Sie, welche Spalte die Zeiten hat, und deren Einheit.","los tiempos de las {what} deben distar {least} s o m\xE1s; aqu\xED distan {got} s. Compruebe qu\xE9 columna tiene los tiempos y su unidad.","les temps des {what} doivent \xEAtre espac\xE9s d'au moins {least} s\xA0; ici {got} s. V\xE9rifiez quelle colonne a les temps, et leur unit\xE9."],"Lines are not in the order of time; they were sorted.":["Die Zeilen stehen nicht in zeitlicher Reihenfolge; sie wurden sortiert.","Las l\xEDneas no est\xE1n en orden temporal; se han ordenado.","Les lignes ne sont pas dans l'ordre du temps\xA0; elles ont \xE9t\xE9 tri\xE9es."],"{count} samples come at a time that was there already; the first of each is kept.":["{count} Messwerte kommen zu einer Zeit, die es schon gab; der jeweils erste wird behalten.","{count} medidas llegan en un tiempo que ya estaba; se conserva la primera de cada uno.","{count} mesures arrivent \xE0 un temps d\xE9j\xE0 pr\xE9sent\xA0; la premi\xE8re de chacun est gard\xE9e."],"The clock is rounded: {count} samples come at a time that was there already, with other values; they are taken at equal steps.":["Die Uhr ist gerundet: {count} Messwerte kommen zu einer Zeit, die es schon gab, mit anderen Werten; sie werden in gleichen Schritten genommen.","El reloj est\xE1 redondeado: {count} medidas llegan en un tiempo que ya estaba, con otros valores; se toman a pasos iguales.","L'horloge est arrondie\xA0: {count} mesures arrivent \xE0 un temps d\xE9j\xE0 pr\xE9sent, avec d'autres valeurs\xA0; elles sont prises \xE0 pas \xE9gaux."],"{what} must be at most {most} in SI units; got {got}. Check which columns they are, and their unit.":["{what} d\xFCrfen h\xF6chstens {most} in SI-Einheiten sein; hier {got}. Pr\xFCfen Sie, welche Spalten es sind, und ihre Einheit.","{what}: como mucho {most} en unidades SI; aqu\xED {got}. Compruebe qu\xE9 columnas son y su unidad.","{what}\xA0: au plus {most} en unit\xE9s SI\xA0; ici {got}. V\xE9rifiez quelles colonnes ce sont, et leur unit\xE9."],"line {line} is not UTF-8 text, so this is not a table. Choose the app's CSV file, unpacked from its archive.":["Zeile {line} ist kein UTF-8-Text, also ist dies keine Tabelle. W\xE4hlen Sie die CSV-Datei der App, aus ihrem Archiv entpackt.","la l\xEDnea {line} no es texto UTF-8, as\xED que esto no es una tabla. Elija el archivo CSV de la aplicaci\xF3n, extra\xEDdo de su archivo comprimido.","la ligne {line} n'est pas du texte UTF-8, donc ce n'est pas une table. Choisissez le fichier CSV de l'application, extrait de son archive."],"line {line} has more than {most} characters. Choose a table with one sample in each line.":["Zeile {line} hat mehr als {most} Zeichen. W\xE4hlen Sie eine Tabelle mit einem Messwert je Zeile.","la l\xEDnea {line} tiene m\xE1s de {most} caracteres. Elija una tabla con una medida por l\xEDnea.","la ligne {line} a plus de {most} caract\xE8res. Choisissez une table avec une mesure par ligne."],"its first line is {text}":["ihre erste Zeile ist {text}","su primera l\xEDnea es {text}","sa premi\xE8re ligne est {text}"],"it is empty":["sie ist leer","est\xE1 vac\xEDo","il est vide"],"it has no line of numbers in two columns or more, between commas, semicolons, tabs or blanks; {first}. Choose a table with one sample in each line.":["Sie hat keine Zeile mit Zahlen in zwei oder mehr Spalten, zwischen Kommas, Strichpunkten, Tabulatoren oder Leerzeichen; {first}. W\xE4hlen Sie eine Tabelle mit einem Messwert je Zeile.","no tiene ninguna l\xEDnea de n\xFAmeros en dos columnas o m\xE1s, entre comas, puntos y comas, tabuladores o espacios; {first}. Elija una tabla con una medida por l\xEDnea.","il n'a pas de ligne de nombres en deux colonnes ou plus, entre virgules, points-virgules, tabulations ou espaces\xA0; {first}. Choisissez une table avec une mesure par ligne."],"line {line} must name the {columns} columns that line {first} has; got {names} names. Name each, or delete the line.":["Zeile {line} muss die {columns} Spalten benennen, die Zeile {first} hat; hier sind es {names} Namen. Benennen Sie jede, oder l\xF6schen Sie die Zeile.","la l\xEDnea {line} debe nombrar las {columns} columnas que tiene la l\xEDnea {first}; tiene {names} nombres. Nombre cada una o borre la l\xEDnea.","la ligne {line} doit nommer les {columns} colonnes de la ligne {first}\xA0; elle a {names} noms. Nommez chacune, ou supprimez la ligne."],"line {line} has quotes that do not close. Check the line.":["Zeile {line} hat Anf\xFChrungszeichen, die nicht schlie\xDFen. Pr\xFCfen Sie die Zeile.","la l\xEDnea {line} tiene comillas que no se cierran. Compruebe la l\xEDnea.","la ligne {line} a des guillemets qui ne se ferment pas. V\xE9rifiez la ligne."],"line {line} has {cells} cells, and line {first} has {width}. Check the line, or delete it.":["Zeile {line} hat {cells} Zellen, und Zeile {first} hat {width}. Pr\xFCfen Sie die Zeile, oder l\xF6schen Sie sie.","la l\xEDnea {line} tiene {cells} celdas, y la l\xEDnea {first} tiene {width}. Compruebe la l\xEDnea o b\xF3rrela.","la ligne {line} a {cells} cellules, et la ligne {first} en a {width}. V\xE9rifiez la ligne, ou supprimez-la."],"line {line} has {cells} cells, and line {first} has {width}. Check the line, or delete it. Is the comma a decimal one? Then save it with semicolons.":["Zeile {line} hat {cells} Zellen, und Zeile {first} hat {width}. Pr\xFCfen Sie die Zeile, oder l\xF6schen Sie sie. Ist das Komma ein Dezimalkomma? Dann speichern Sie mit Strichpunkten.","la l\xEDnea {line} tiene {cells} celdas, y la l\xEDnea {first} tiene {width}. Compruebe la l\xEDnea o b\xF3rrela. \xBFEs la coma decimal? Entonces gu\xE1rdela con puntos y comas.","la ligne {line} a {cells} cellules, et la ligne {first} en a {width}. V\xE9rifiez la ligne, ou supprimez-la. La virgule est-elle d\xE9cimale\xA0? Alors enregistrez avec des points-virgules."],"{where}: {cell} has a point, and the other numbers have decimal commas. Choose one of them.":["{where}: {cell} hat einen Punkt, und die anderen Zahlen haben Dezimalkommas. W\xE4hlen Sie eins davon.","{where}: {cell} tiene un punto, y los otros n\xFAmeros tienen comas decimales. Elija uno de los dos.","{where}\xA0: {cell} a un point, et les autres nombres ont des virgules d\xE9cimales. Choisissez l'un des deux."],"must be a number in decimal digits":["muss eine Zahl in Dezimalziffern sein","debe ser un n\xFAmero en cifras decimales","doit \xEAtre un nombre en chiffres d\xE9cimaux"],"is so small that nothing is left of it":["ist so klein, dass nichts davon \xFCbrig bleibt","es tan peque\xF1o que no queda nada de \xE9l","est si petit qu'il n'en reste rien"],"is too large for a number":["ist zu gro\xDF f\xFCr eine Zahl","es demasiado grande para un n\xFAmero","est trop grand pour un nombre"],"Dates and times of day are not read: give times as plain numbers, like seconds from the start.":["Datum und Uhrzeit werden nicht gelesen: Geben Sie Zeiten als einfache Zahlen an, etwa Sekunden vom Anfang an.","No se leen fechas ni horas: d\xE9 los tiempos como n\xFAmeros, por ejemplo segundos desde el inicio.","Les dates et heures ne sont pas lues\xA0: donnez les temps en simples nombres, comme des secondes depuis le d\xE9part."],"Correct it, or leave the cell blank.":["Berichtigen Sie sie, oder lassen Sie die Zelle leer.","Corr\xEDjala o deje la celda en blanco.","Corrigez-la, ou laissez la cellule vide."],"keeps an angular momentum":["beh\xE4lt einen Drehimpuls","conserva un momento angular","conserve un moment cin\xE9tique"],"the accelerometer feels no weight":["der Beschleunigungsmesser sp\xFCrt kein Gewicht","el aceler\xF3metro no siente peso","l'acc\xE9l\xE9rom\xE8tre ne sent aucun poids"],"no free flight was found in the log: no stretch of a quarter of a second keeps an angular momentum, or feels no weight. Throw it with a spin of a turn a second or more, and log from before the throw until after the catch.":["In der Aufzeichnung wurde kein freier Flug gefunden: Kein Abschnitt von einer Viertelsekunde beh\xE4lt einen Drehimpuls oder sp\xFCrt kein Gewicht. Werfen Sie mit einer Umdrehung je Sekunde oder mehr, und zeichnen Sie von vor dem Wurf bis nach dem Fangen auf.","no se ha hallado ning\xFAn vuelo libre en el registro: ning\xFAn tramo de un cuarto de segundo conserva un momento angular o no siente peso. Lance con una vuelta por segundo o m\xE1s, y registre desde antes del lanzamiento hasta despu\xE9s de la captura.","aucun vol libre n'a \xE9t\xE9 trouv\xE9 dans le relev\xE9\xA0: aucun intervalle d'un quart de seconde ne conserve un moment cin\xE9tique ou ne sent aucun poids. Lancez avec un tour par seconde ou plus, et enregistrez d'avant le lancer jusqu'apr\xE8s la r\xE9ception."],"a throw must have {least} samples that are not at the gyro's limit; got {count}. Throw more slowly.":["Ein Wurf muss {least} Messwerte haben, die nicht an der Grenze des Gyros liegen; hier sind es {count}. Werfen Sie langsamer.","un lanzamiento debe tener {least} medidas que no est\xE9n en el l\xEDmite del gir\xF3scopo; hay {count}. Lance m\xE1s despacio.","un lancer doit avoir {least} mesures hors de la limite du gyroscope\xA0; ici {count}. Lancez plus lentement."],"no free motion of a rigid body explains the log: the residuals, {residuals} rad/s, are not small beside the rates, {rates} rad/s. Check columns and units, or log a free flight.":["Keine freie Bewegung eines starren K\xF6rpers erkl\xE4rt die Aufzeichnung: Die Residuen, {residuals} rad/s, sind nicht klein gegen die Drehraten, {rates} rad/s. Pr\xFCfen Sie Spalten und Einheiten, oder zeichnen Sie einen freien Flug auf.","ning\xFAn movimiento libre de un s\xF3lido r\xEDgido explica el registro: los residuos, {residuals} rad/s, no son peque\xF1os frente a las velocidades, {rates} rad/s. Compruebe columnas y unidades, o registre un vuelo libre.","aucun mouvement libre d'un solide n'explique le relev\xE9\xA0: les r\xE9sidus, {residuals} rad/s, ne sont pas petits devant les vitesses, {rates} rad/s. V\xE9rifiez colonnes et unit\xE9s, ou enregistrez un vol libre."],"{times} times the noise of a sample":["{times}-mal das Rauschen eines Messwerts","{times} veces el ruido de una medida","{times} fois le bruit d'une mesure"],"alike from sample to sample (correlation {correlation})":["von Messwert zu Messwert \xE4hnlich (Korrelation {correlation})","parecidos de una medida a otra (correlaci\xF3n {correlation})","semblables d'une mesure \xE0 l'autre (corr\xE9lation {correlation})"],"larger than the noise at a few samples, up to {most} rad/s":["bei einigen Messwerten gr\xF6\xDFer als das Rauschen, bis {most} rad/s","mayores que el ruido en algunas medidas, hasta {most} rad/s","plus grands que le bruit \xE0 quelques mesures, jusqu'\xE0 {most} rad/s"],"The log is not the motion of a rigid body with drag within its noise: the residuals ({rms} rad/s rms, noise {noise} rad/s) are {why}.":["Die Aufzeichnung ist innerhalb ihres Rauschens nicht die Bewegung eines starren K\xF6rpers mit Luftwiderstand: Die Residuen ({rms} rad/s rms, Rauschen {noise} rad/s) sind {why}.","El registro no es, dentro de su ruido, el movimiento de un s\xF3lido r\xEDgido con arrastre: los residuos ({rms} rad/s rms, ruido {noise} rad/s) son {why}.","Le relev\xE9 n'est pas, au bruit pr\xE8s, le mouvement d'un solide avec tra\xEEn\xE9e\xA0: les r\xE9sidus ({rms} rad/s rms, bruit {noise} rad/s) sont {why}."],"The log is not a free rigid body's motion within its noise: the residuals ({rms} rad/s rms, noise {noise} rad/s) are {why}.":["Die Aufzeichnung ist innerhalb ihres Rauschens nicht die Bewegung eines freien starren K\xF6rpers: Die Residuen ({rms} rad/s rms, Rauschen {noise} rad/s) sind {why}.","El registro no es, dentro de su ruido, el movimiento de un s\xF3lido r\xEDgido libre: los residuos ({rms} rad/s rms, ruido {noise} rad/s) son {why}.","Le relev\xE9 n'est pas, au bruit pr\xE8s, le mouvement d'un solide libre\xA0: les r\xE9sidus ({rms} rad/s rms, bruit {noise} rad/s) sont {why}."],"A gyro's gains, a clock that jitters or a catch within the window do that; polhode fit fits gains too, and gives errors.":["Verst\xE4rkungen des Gyros, eine unruhige Uhr oder ein Fangen im Zeitfenster bewirken das; polhode fit passt auch Verst\xE4rkungen an und gibt Fehler an.","Las ganancias del gir\xF3scopo, un reloj irregular o una captura dentro de la ventana lo causan; polhode fit ajusta tambi\xE9n las ganancias y da los errores.","Les gains du gyroscope, une horloge irr\xE9guli\xE8re ou une r\xE9ception dans la fen\xEAtre en sont la cause\xA0; polhode fit ajuste aussi les gains, et donne les erreurs."],"The rates say that the body turns by {angle} rad from sample to sample, too far to be followed: the rates are of another unit, like deg/s, or the times are.":["Den Drehraten nach dreht sich der K\xF6rper von Messwert zu Messwert um {angle} rad, zu weit, um ihm zu folgen: Die Drehraten haben eine andere Einheit, etwa deg/s, oder die Zeiten.","Seg\xFAn las velocidades, el cuerpo gira {angle} rad de una medida a otra, demasiado para seguirlo: las velocidades est\xE1n en otra unidad, como deg/s, o lo est\xE1n los tiempos.","D'apr\xE8s les vitesses, le corps tourne de {angle} rad d'une mesure \xE0 l'autre, trop pour \xEAtre suivi\xA0: les vitesses sont dans une autre unit\xE9, comme deg/s, ou les temps le sont."],"The rates, about {rates} rad/s, are beyond what gyros can tell, and make the body nearly a sphere. Both happen where rates in deg/s are read as rad/s: choose their unit.":["Die Drehraten, etwa {rates} rad/s, liegen \xFCber dem, was Gyros messen, und machen den K\xF6rper fast zur Kugel. Beides geschieht, wo Drehraten in deg/s als rad/s gelesen werden: W\xE4hlen Sie ihre Einheit.","Las velocidades, unos {rates} rad/s, superan lo que miden los gir\xF3scopos y hacen del cuerpo casi una esfera. Ambas cosas ocurren cuando velocidades en deg/s se leen como rad/s: elija su unidad.","Les vitesses, environ {rates} rad/s, d\xE9passent ce que mesurent les gyroscopes, et font du corps presque une sph\xE8re. Cela arrive quand des vitesses en deg/s sont lues en rad/s\xA0: choisissez leur unit\xE9."],"The body turned by {angle} rad only: nothing can be said of its inertia.":["Der K\xF6rper hat sich nur um {angle} rad gedreht: \xDCber seine Tr\xE4gheit l\xE4sst sich nichts sagen.","El cuerpo solo ha girado {angle} rad: nada puede decirse de su inercia.","Le corps n'a tourn\xE9 que de {angle} rad\xA0: on ne peut rien dire de son inertie."],"The rates ({rates} rad/s) stay within {angle}\xB0 of one direction of the device, {axis}: the body spins about a principal axis, or is a sphere; either way the log does not determine the moments. Throw it with a tumble, best about its middle axis.":["Die Drehraten ({rates} rad/s) bleiben innerhalb von {angle}\xB0 um eine Richtung des Ger\xE4ts, {axis}: Der K\xF6rper dreht sich um eine Hauptachse, oder er ist ein Kugelkreisel; so oder so bestimmt die Aufzeichnung die Tr\xE4gheitsmomente nicht. Werfen Sie ihn taumelnd, am besten um seine mittlere Achse.","Las velocidades ({rates} rad/s) se mantienen a menos de {angle}\xB0 de una direcci\xF3n del aparato, {axis}: el cuerpo gira en torno a un eje principal, o es una esfera; en ambos casos el registro no determina los momentos. L\xE1ncelo dando tumbos, mejor en torno a su eje intermedio.","Les vitesses ({rates} rad/s) restent \xE0 moins de {angle}\xB0 d'une direction de l'appareil, {axis}\xA0: le corps tourne autour d'un axe principal, ou c'est une sph\xE8re\xA0; dans les deux cas le relev\xE9 ne d\xE9termine pas les moments. Lancez-le en le faisant culbuter, de pr\xE9f\xE9rence autour de son axe interm\xE9diaire."],"Within the noise, bodies of quite different moments fit the rates ({rates} rad/s, up to {angle}\xB0 from {axis}). Throw it longer or faster, with a tumble about its middle axis.":["Innerhalb des Rauschens passen K\xF6rper mit recht verschiedenen Tr\xE4gheitsmomenten zu den Drehraten ({rates} rad/s, bis {angle}\xB0 von {axis}). Werfen Sie ihn l\xE4nger oder schneller, taumelnd um seine mittlere Achse.","Dentro del ruido, cuerpos de momentos bastante distintos se ajustan a las velocidades ({rates} rad/s, hasta {angle}\xB0 de {axis}). L\xE1ncelo m\xE1s tiempo o m\xE1s r\xE1pido, dando tumbos en torno a su eje intermedio.","Au bruit pr\xE8s, des corps de moments assez diff\xE9rents conviennent aux vitesses ({rates} rad/s, jusqu'\xE0 {angle}\xB0 de {axis}). Lancez-le plus longtemps ou plus vite, en culbute autour de son axe interm\xE9diaire."],"Free flight from {begin} s to {end} s of the log, and the exact motion of the fitted body: {ratios}.":["Freier Flug von {begin} s bis {end} s der Aufzeichnung, und die exakte Bewegung des angepassten K\xF6rpers: {ratios}.","Vuelo libre de {begin} s a {end} s del registro, y el movimiento exacto del cuerpo ajustado: {ratios}.","Vol libre de {begin} s \xE0 {end} s du relev\xE9, et le mouvement exact du corps ajust\xE9\xA0: {ratios}."],"A gyro tells the moments up to a common factor: on this page the largest is 1 kg m\xB2.":["Ein Gyro bestimmt die Tr\xE4gheitsmomente bis auf einen gemeinsamen Faktor: Auf dieser Seite ist das gr\xF6\xDFte 1 kg m\xB2.","Un gir\xF3scopo da los momentos salvo un factor com\xFAn: en esta p\xE1gina el mayor es 1 kg m\xB2.","Un gyroscope donne les moments \xE0 un facteur commun pr\xE8s\xA0: sur cette page le plus grand vaut 1 kg m\xB2."],"Read as a log of {app}, rates in {unit}.":["Gelesen als Aufzeichnung von {app}, Drehraten in {unit}.","Le\xEDdo como registro de {app}, velocidades en {unit}.","Lu comme relev\xE9 de {app}, vitesses en {unit}."],"Rates are read in {unit}, as chosen.":["Drehraten werden in {unit} gelesen, wie gew\xE4hlt.","Las velocidades se leen en {unit}, como se ha elegido.","Les vitesses sont lues en {unit}, comme choisi."],"{count} free flights are found; this one lasts {duration} s: {reason}.":["{count} freie Fl\xFCge sind gefunden; dieser dauert {duration} s: {reason}.","Se hallan {count} vuelos libres; este dura {duration} s: {reason}.","{count} vols libres sont trouv\xE9s\xA0; celui-ci dure {duration} s\xA0: {reason}."],"One free flight is found; it lasts {duration} s: {reason}.":["Ein freier Flug ist gefunden; er dauert {duration} s: {reason}.","Se halla un vuelo libre; dura {duration} s: {reason}.","Un vol libre est trouv\xE9\xA0; il dure {duration} s\xA0: {reason}."],"{ratios}; the gyro's bias is {bias} rad/s, which a rest confirms.":["{ratios}; der Nullpunktfehler des Gyros ist {bias} rad/s, was eine Ruhe best\xE4tigt.","{ratios}; el sesgo del gir\xF3scopo es {bias} rad/s, lo que un reposo confirma.","{ratios}\xA0; le biais du gyroscope est {bias} rad/s, ce qu'un repos confirme."],"{ratios}; the gyro's bias is {bias} rad/s, and no rest in the log confirms it.":["{ratios}; der Nullpunktfehler des Gyros ist {bias} rad/s, und keine Ruhe in der Aufzeichnung best\xE4tigt ihn.","{ratios}; el sesgo del gir\xF3scopo es {bias} rad/s, y ning\xFAn reposo del registro lo confirma.","{ratios}\xA0; le biais du gyroscope est {bias} rad/s, et aucun repos du relev\xE9 ne le confirme."],"Drag slows it: c/I3 = {numbers} of the torque \u2212c |\u03C9| \u03C9 along the axes.":["Luftwiderstand bremst ihn: c/I3 = {numbers} des Drehmoments \u2212c |\u03C9| \u03C9 entlang der Achsen.","El arrastre lo frena: c/I3 = {numbers} del momento \u2212c |\u03C9| \u03C9 seg\xFAn los ejes.","La tra\xEEn\xE9e le ralentit\xA0: c/I3 = {numbers} du moment \u2212c |\u03C9| \u03C9 selon les axes."],"The curves are of the free motion that touches it in the middle of the flight.":["Die Kurven sind die der freien Bewegung, die sie in der Mitte des Flugs ber\xFChrt.","Las curvas son las del movimiento libre que lo toca en la mitad del vuelo.","Les courbes sont celles du mouvement libre qui lui est tangent au milieu du vol."],"The residuals, {rms} rad/s rms, are those of the noise, {noise} rad/s: within it the log is the motion of a rigid body with drag.":["Die Residuen, {rms} rad/s rms, sind die des Rauschens, {noise} rad/s: Innerhalb davon ist die Aufzeichnung die Bewegung eines starren K\xF6rpers mit Luftwiderstand.","Los residuos, {rms} rad/s rms, son los del ruido, {noise} rad/s: dentro de \xE9l, el registro es el movimiento de un s\xF3lido r\xEDgido con arrastre.","Les r\xE9sidus, {rms} rad/s rms, sont ceux du bruit, {noise} rad/s\xA0: \xE0 celui-ci pr\xE8s, le relev\xE9 est le mouvement d'un solide avec tra\xEEn\xE9e."],"The residuals, {rms} rad/s rms, are those of the noise, {noise} rad/s: within it the log is the motion of a free rigid body.":["Die Residuen, {rms} rad/s rms, sind die des Rauschens, {noise} rad/s: Innerhalb davon ist die Aufzeichnung die Bewegung eines freien starren K\xF6rpers.","Los residuos, {rms} rad/s rms, son los del ruido, {noise} rad/s: dentro de \xE9l, el registro es el movimiento de un s\xF3lido r\xEDgido libre.","Les r\xE9sidus, {rms} rad/s rms, sont ceux du bruit, {noise} rad/s\xA0: \xE0 celui-ci pr\xE8s, le relev\xE9 est le mouvement d'un solide libre."],"Samples at the gyro's limit, {limit} deg/s, are left out; {count} remain.":["Messwerte an der Grenze des Gyros, {limit} deg/s, bleiben weg; {count} bleiben \xFCbrig.","Se omiten las medidas en el l\xEDmite del gir\xF3scopo, {limit} deg/s; quedan {count}.","Les mesures \xE0 la limite du gyroscope, {limit} deg/s, sont omises\xA0; il en reste {count}."],"T-handle":["T-Griff","Mango en T","Poign\xE9e en T"],Book:["Buch","Libro","Livre"],Phone:["Telefon","Tel\xE9fono","T\xE9l\xE9phone"],Earth:["Erde","Tierra","Terre"],Apophis:["Apophis","Apofis","Apophis"],"Spinning top":["Kreisel","Trompo","Toupie"],"Steady precession":["Regul\xE4re Pr\xE4zession","Precesi\xF3n regular","Pr\xE9cession r\xE9guli\xE8re"],Gyroscope:["Gyroskop","Gir\xF3scopo","Gyroscope"],"Dual-spin spacecraft":["Dual-Spin-Satellit","Sat\xE9lite de doble giro","Satellite \xE0 double rotation"],"Explorer 1":["Explorer 1","Explorer 1","Explorer 1"],"Euler's disk":["Euler-Scheibe","Disco de Euler","Disque d'Euler"],"Quantum racket":["Quantenschl\xE4ger","Raqueta cu\xE1ntica","Raquette quantique"],"[It spins about its intermediate axis] and turns over, again and again, although nothing acts on it.":["[Er dreht sich um seine mittlere Hauptachse] und kippt um, immer wieder, obwohl nichts auf ihn wirkt.","[Gira en torno a su eje intermedio] y se da la vuelta, una y otra vez, aunque nada act\xFAa sobre \xE9l.","[Elle tourne autour de son axe interm\xE9diaire] et se retourne, encore et encore, bien que rien n'agisse sur elle."],"[Tilt it by 5\xB0], and it still turns over, only sooner.":["[Um 5\xB0 geneigt] kippt er immer noch um, nur fr\xFCher.","[Incl\xEDnelo 5\xB0], y sigue d\xE1ndose la vuelta, solo que antes.","[Inclinez-la de 5\xB0], et elle se retourne encore, seulement plus t\xF4t."],"[By a thousandth of a degree]: it waits longer each time, but it turns over.":["[Um ein Tausendstel Grad]: Er wartet jedes Mal l\xE4nger, aber er kippt um.","[Una mil\xE9sima de grado]: cada vez espera m\xE1s, pero se da la vuelta.","[D'un milli\xE8me de degr\xE9]\xA0: elle attend plus longtemps chaque fois, mais elle se retourne."],"[About the axis of its largest moment] it never turns over: the axis cones, within 3.5\xB0 of L.":["[Um die Achse des gr\xF6\xDFten Tr\xE4gheitsmoments] kippt er nie um: Die Achse beschreibt einen Kegel, h\xF6chstens 3,5\xB0 von L.","[En torno al eje de mayor momento de inercia] nunca se da la vuelta: el eje describe un cono, a menos de 3,5\xB0 de L.","[Autour de l'axe de plus grand moment d'inertie] elle ne se retourne jamais\xA0: l'axe d\xE9crit un c\xF4ne, \xE0 moins de 3,5\xB0 de L."],"Take hold of the blue point [on the sphere] and drag it from one side of the orange curve to the other.":["Fassen Sie den blauen Punkt [auf der Kugel] und ziehen Sie ihn von einer Seite der orangen Kurve auf die andere.","Tome el punto azul [sobre la esfera] y arr\xE1strelo de un lado de la curva naranja al otro.","Saisissez le point bleu [sur la sph\xE8re] et faites-le glisser d'un c\xF4t\xE9 de la courbe orange \xE0 l'autre."],"A book [thrown about its middle axis] turns over: watch the cover turn away.":["Ein Buch, [um seine mittlere Achse geworfen], kippt um: Sehen Sie, wie der Deckel sich wegdreht.","Un libro [lanzado en torno a su eje intermedio] se da la vuelta: vea c\xF3mo se aleja la tapa.","Un livre [lanc\xE9 autour de son axe interm\xE9diaire] se retourne\xA0: regardez la couverture s'\xE9loigner."],"[Thrown about its longest axis] it keeps to it: the axis cones, within 6.3\xB0 of L.":["[Um seine l\xE4ngste Achse geworfen] bleibt es dabei: Die Achse beschreibt einen Kegel, h\xF6chstens 6,3\xB0 von L.","[Lanzado en torno a su eje m\xE1s largo] lo mantiene: el eje describe un cono, a menos de 6,3\xB0 de L.","[Lanc\xE9 autour de son axe le plus long] il s'y tient\xA0: l'axe d\xE9crit un c\xF4ne, \xE0 moins de 6,3\xB0 de L."],"[Thrown flat], like a tray, it keeps that axis as well, within 2.1\xB0.":["[Flach geworfen], wie ein Tablett, beh\xE4lt es auch diese Achse, bis auf 2,1\xB0.","[Lanzado plano], como una bandeja, tambi\xE9n mantiene ese eje, a menos de 2,1\xB0.","[Lanc\xE9 \xE0 plat], comme un plateau, il garde aussi cet axe, \xE0 2,1\xB0 pr\xE8s."],"A phone [tossed about its width] is twisted by only 14\xB0 when it has turned once, at 0.53 s. The half twist comes with the second turn: it turns over at 0.74 s.":["Ein Telefon, [um seine Breite geworfen], ist nach einer Umdrehung, bei 0,53 s, nur um 14\xB0 verdreht. Die halbe Drehung kommt mit der zweiten Umdrehung: Es kippt bei 0,74 s um.","Un tel\xE9fono [lanzado en torno a su ancho] solo se ha torcido 14\xB0 tras una vuelta, a los 0,53 s. El medio giro llega con la segunda vuelta: se da la vuelta a los 0,74 s.","Un t\xE9l\xE9phone [lanc\xE9 autour de sa largeur] n'est vrill\xE9 que de 14\xB0 apr\xE8s un tour, \xE0 0,53 s. La demi-vrille vient avec le deuxi\xE8me tour\xA0: il se retourne \xE0 0,74 s."],"[Make the tilt smaller]: the twist comes later, and a short toss does not show it.":["[Die Neigung kleiner]: Die Drehung kommt sp\xE4ter, und ein kurzer Wurf zeigt sie nicht.","[Reduzca la inclinaci\xF3n]: el giro llega m\xE1s tarde, y un lanzamiento corto no lo muestra.","[R\xE9duisez l'inclinaison]\xA0: la vrille vient plus tard, et un lancer court ne la montre pas."],"A rigid Earth's axis of rotation [goes round the axis of its shape] in some 304 days; measured, it is 433, as the Earth gives way.":["Die Drehachse einer starren Erde [uml\xE4uft ihre Figurenachse] in etwa 304 Tagen; gemessen sind es 433, da die Erde nachgibt.","El eje de rotaci\xF3n de una Tierra r\xEDgida [da la vuelta al eje de figura] en unos 304 d\xEDas; lo medido son 433, pues la Tierra cede.","L'axe de rotation d'une Terre rigide [fait le tour de l'axe de figure] en quelque 304 jours\xA0; la mesure donne 433, car la Terre se d\xE9forme."],"Its circle has a radius of 6 m at the pole. [Give it ten degrees] to see it.":["Sein Kreis hat am Pol einen Radius von 6 m. [Zehn Grad] machen ihn sichtbar.","Su c\xEDrculo tiene un radio de 6 m en el polo. [Dele diez grados] para verlo.","Son cercle a un rayon de 6 m au p\xF4le. [Donnez-lui dix degr\xE9s] pour le voir."],"The asteroid [tumbles]: it turns about L, and about itself, at periods that have nothing to do with each other.":["Der Asteroid [taumelt]: Er dreht sich um L und um sich selbst, mit Perioden, die nichts miteinander zu tun haben.","El asteroide [da tumbos]: gira en torno a L y sobre s\xED mismo, con per\xEDodos que nada tienen que ver entre s\xED.","L'ast\xE9ro\xEFde [culbute]\xA0: il tourne autour de L, et sur lui-m\xEAme, avec des p\xE9riodes sans rapport entre elles."],"[Set its spin along axis 3], and all that is left is a plain turn.":["[Die Drehung entlang Achse 3], und es bleibt nur eine einfache Drehung.","[Ponga su giro seg\xFAn el eje 3], y solo queda un giro simple.","[Mettez sa rotation selon l'axe 3], et il ne reste qu'une simple rotation."],"[Let go], the top falls, is turned aside, and comes back to rest at a cusp, again and again.":["[Losgelassen] f\xE4llt der Kreisel, wird abgelenkt und kommt in einer Spitze wieder zur Ruhe, immer wieder.","[Suelto], el trompo cae, se desv\xEDa y vuelve al reposo en una c\xFAspide, una y otra vez.","[L\xE2ch\xE9e], la toupie tombe, est d\xE9vi\xE9e, et revient au repos \xE0 un point de rebroussement, encore et encore."],"[Push it along] as you let go, and the cusps open.":["[Beim Loslassen angesto\xDFen], und die Spitzen \xF6ffnen sich.","[Emp\xFAjelo hacia delante] al soltarlo, y las c\xFAspides se abren.","[Poussez-la en avant] en la l\xE2chant, et les points de rebroussement s'ouvrent."],"[Push it back], and the axis runs in loops.":["[Zur\xFCckgesto\xDFen], und die Achse l\xE4uft in Schleifen.","[Emp\xFAjelo hacia atr\xE1s], y el eje describe lazos.","[Poussez-la en arri\xE8re], et l'axe d\xE9crit des boucles."],"[Upright and fast enough] it sleeps.":["[Aufrecht und schnell genug] schl\xE4ft er.","[Vertical y lo bastante r\xE1pido] duerme.","[Debout et assez rapide] elle dort."],"[At just the right rate] the axis goes round at constant lean.":["[Mit genau der richtigen Rate] pr\xE4zediert die Achse mit gleicher Neigung.","[Con la velocidad justa] el eje precesa con inclinaci\xF3n constante.","[\xC0 la vitesse juste] l'axe pr\xE9cesse \xE0 inclinaison constante."],"[Let go at half that rate], it nods, down to 70\xB0.":["[Mit der halben Rate losgelassen] nickt sie, bis auf 70\xB0.","[Soltada a la mitad de esa velocidad], cabecea, hasta 70\xB0.","[L\xE2ch\xE9e \xE0 la moiti\xE9 de cette vitesse], elle se balance, jusqu'\xE0 70\xB0."],"[Held at one end], the wheel does not fall: its axis goes round, nodding a little.":["[An einem Ende gehalten] f\xE4llt das Rad nicht: Seine Achse pr\xE4zediert und nickt ein wenig.","[Sujeta por un extremo], la rueda no cae: su eje precesa, cabeceando un poco.","[Tenue par un bout], la roue ne tombe pas\xA0: son axe pr\xE9cesse, en nutant un peu."],"[Let it spin at a tenth], and it nods deeply.":["[Bei einem Zehntel der Drehung] nickt es tief.","[H\xE1gala girar a la d\xE9cima parte], y cabecea mucho.","[Faites-la tourner dix fois moins vite], et elle nute fortement."],"The drum that [spins inside] holds L within 6.3\xB0 of its axis, the axis of least moment, where the body alone would not stay once it loses energy. The levels on the sphere move with the drum's speed.":["Die Trommel, die sich [im Innern dreht], h\xE4lt L innerhalb von 6,3\xB0 um ihre Achse, die Achse des kleinsten Tr\xE4gheitsmoments, wo der K\xF6rper allein nicht bliebe, sobald er Energie verliert. Die Niveaulinien auf der Kugel wandern mit der Drehzahl der Trommel.","El tambor que [gira en el interior] mantiene L a menos de 6,3\xB0 de su eje, el de menor momento, donde el cuerpo solo no se quedar\xEDa al perder energ\xEDa. Los niveles sobre la esfera se mueven con la velocidad del tambor.","Le tambour qui [tourne \xE0 l'int\xE9rieur] tient L \xE0 moins de 6,3\xB0 de son axe, l'axe de plus petit moment, o\xF9 le corps seul ne resterait pas d\xE8s qu'il perd de l'\xE9nergie. Les niveaux sur la sph\xE8re se d\xE9placent avec la vitesse du tambour."],"[Stop the rotor] by its own motor: L stays, and the whole satellite now turns with the drum, at 56 rpm and within 6.3\xB0 of its axis. That spin has the most energy for its L, and losses would end it.":["[Rotor anhalten], durch seinen eigenen Motor: L bleibt, und der ganze Satellit dreht sich nun mit der Trommel, mit 56 U/min und innerhalb von 6,3\xB0 um ihre Achse. Diese Drehung hat die meiste Energie bei ihrem L, und Verluste w\xFCrden sie beenden.","[Parar el rotor] con su propio motor: L se mantiene, y todo el sat\xE9lite gira ahora con el tambor, a 56 rpm y a menos de 6,3\xB0 de su eje. Ese giro tiene la m\xE1xima energ\xEDa para su L, y las p\xE9rdidas acabar\xEDan con \xE9l.","[Arr\xEAter le rotor] par son propre moteur : L reste, et tout le satellite tourne maintenant avec le tambour, \xE0 56 tr/min et \xE0 moins de 6,3\xB0 de son axe. Cette rotation a le plus d'\xE9nergie pour son L, et des pertes y mettraient fin."],"A slender satellite, [spun about its long axis]: whips of wire lose energy, L stays, and in the end it turns end over end. The losses are enlarged some 4000 times: here it takes 1.6 s, and the satellite took an orbit, 115 minutes.":["Ein schlanker Satellit, [um seine L\xE4ngsachse gedreht]: Drahtantennen verlieren Energie, L bleibt, und am Ende \xFCberschl\xE4gt er sich. Die Verluste sind etwa 4000-fach vergr\xF6\xDFert: Hier dauert es 1,6 s, beim Satelliten war es ein Umlauf, 115 Minuten.","Un sat\xE9lite esbelto, [girado alrededor de su eje largo]: las antenas de alambre pierden energ\xEDa, L se mantiene, y al final da vueltas de campana. Las p\xE9rdidas est\xE1n aumentadas unas 4000 veces: aqu\xED tarda 1,6 s, y el sat\xE9lite tard\xF3 una \xF3rbita, 115 minutos.","Un satellite \xE9lanc\xE9, [lanc\xE9 autour de son axe long] : des antennes en fil perdent de l'\xE9nergie, L reste, et \xE0 la fin il culbute. Les pertes sont agrandies environ 4000 fois : ici cela prend 1,6 s, et le satellite a mis une orbite, 115 minutes."],"[With a tenth of the losses] it takes ten times as long.":["[Mit einem Zehntel der Verluste] dauert es zehnmal so lange.","[Con una d\xE9cima parte de las p\xE9rdidas] tarda diez veces m\xE1s.","[Avec un dixi\xE8me des pertes] cela prend dix fois plus de temps."],"[Tilted by 12\xB0] its contact goes round 11 times a second. Rolling friction and air take its energy, and after 81 s it lies flat. The button under the picture lets you hear it.":["[Um 12\xB0 geneigt] l\xE4uft ihr Ber\xFChrpunkt 11-mal je Sekunde um. Rollreibung und Luft nehmen ihr die Energie, und nach 81 s liegt sie flach. Der Knopf unter dem Bild macht sie h\xF6rbar.","[Inclinado 12\xB0], su contacto da la vuelta 11 veces por segundo. La fricci\xF3n de rodadura y el aire le quitan energ\xEDa, y tras 81 s queda plano. El bot\xF3n bajo la imagen permite o\xEDrlo.","[Inclin\xE9 de 12\xB0], son contact fait le tour 11 fois par seconde. Le frottement de roulement et l'air prennent son \xE9nergie, et apr\xE8s 81 s il est \xE0 plat. Le bouton sous l'image le fait entendre."],"The lower it lies, the faster it rattles: [begun at 1\xB0], its contact goes round 38 times a second. Its face hardly seems to move, and it lies flat 0.54 s later.":["Je flacher sie liegt, desto schneller klappert sie: [Bei 1\xB0 begonnen] l\xE4uft ihr Ber\xFChrpunkt 38-mal je Sekunde um. Ihre Fl\xE4che scheint sich kaum zu bewegen, und 0,54 s sp\xE4ter liegt sie flach.","Cuanto m\xE1s bajo est\xE1, m\xE1s r\xE1pido repiquetea: [iniciado a 1\xB0], su contacto da la vuelta 38 veces por segundo. Su cara apenas parece moverse, y queda plano 0,54 s despu\xE9s.","Plus il est bas, plus il cr\xE9pite vite\xA0: [parti de 1\xB0], son contact fait le tour 38 fois par seconde. Sa face semble \xE0 peine bouger, et il est \xE0 plat 0,54 s plus tard."],"A racket with 20 quanta of spin: each curve [on the sphere] is one of its 41 levels. Press play: L is not sharp, so the cloud of classical bodies spreads while it turns over, and the quantum state makes waves where the cloud folds.":["Ein Schl\xE4ger mit 20 Drehimpulsquanten: Jede Kurve [auf der Kugel] ist eines seiner 41 Niveaus. Dr\xFCcken Sie auf Abspielen: L ist nicht scharf, darum zerl\xE4uft die Wolke klassischer K\xF6rper beim Umkippen, und der Quantenzustand macht Wellen, wo die Wolke sich faltet.","Una raqueta con 20 cuantos de momento angular: cada curva [sobre la esfera] es uno de sus 41 niveles. Pulse reproducir: L no est\xE1 bien definido, as\xED que la nube de cuerpos cl\xE1sicos se extiende al darse la vuelta, y el estado cu\xE1ntico hace ondas donde la nube se pliega.","Une raquette avec 20 quanta de moment cin\xE9tique\xA0: chaque courbe [sur la sph\xE8re] est l'un de ses 41 niveaux. Lancez la lecture\xA0: L n'est pas d\xE9fini exactement, donc le nuage de corps classiques s'\xE9tale en se retournant, et l'\xE9tat quantique fait des ondes l\xE0 o\xF9 le nuage se plie."],"[Stand it on the middle axis] itself: a classical body stays there for ever, the quantum one turns over all the same.":["[Genau auf der mittleren Achse]: Ein klassischer K\xF6rper bleibt dort f\xFCr immer, der quantenmechanische kippt trotzdem um.","[P\xF3ngala sobre el eje intermedio] mismo: un cuerpo cl\xE1sico se queda ah\xED para siempre, el cu\xE1ntico se da la vuelta igualmente.","[Placez-la sur l'axe interm\xE9diaire] m\xEAme\xA0: un corps classique y reste pour toujours, le quantique se retourne quand m\xEAme."],"[One level alone] does not move: its state lies along a polhode and its mirror image, with waves between them.":["[Ein einzelnes Niveau] bewegt sich nicht: Sein Zustand liegt entlang einer Polhodie und ihrem Spiegelbild, mit Wellen dazwischen.","[Un solo nivel] no se mueve: su estado sigue una polhodia y su imagen especular, con ondas entre ellas.","[Un seul niveau] ne bouge pas\xA0: son \xE9tat suit une polhodie et son image miroir, avec des ondes entre elles."]}};var qx=["aria-label","title","alt"],Xx=i=>document.getElementById(i),Yu=class{changed=()=>{};constructor(){kg(Wx),this.places=KC(document.body),this.asked=null,this.select=Xx("language"),this.select.append(...rr().map(e=>new Option(jC(e),e))),this.select.addEventListener("change",()=>{this.take(this.select.value),this.changed()})}take(e){this.asked=rr().includes(e)?e:null,Gg(this.asked??zg(navigator.languages??[])),document.documentElement.lang=uu(),document.title=W(this.title??=document.title),this.select.value=uu(),Xx("language-code").textContent=uu().toUpperCase();for(let t of this.places)t.put(W(t.english))}};function jC(i){try{let e=new Intl.DisplayNames([i],{type:"language"}).of(i);return e[0].toUpperCase()+e.slice(1)}catch{return i}}function KC(i){let e=[],t=document.createTreeWalker(i,NodeFilter.SHOW_TEXT);for(let n=t.nextNode();n;n=t.nextNode()){let s=n.data.trim();if(!$x(s)||n.parentElement.closest("script, style, noscript"))continue;let r=n,[o,a]=n.data.split(s);e.push({english:s,put:l=>r.data=o+l+a})}for(let n of i.querySelectorAll(qx.map(s=>`[${s}]`).join()))for(let s of qx){let r=n.getAttribute(s);r&&$x(r)&&e.push({english:r,put:o=>n.setAttribute(s,o)})}return e}var $x=i=>/\p{L}{2}/u.test(i);var Zu=class{constructor(e,t){this.root=e,this.changed=t,this.large=0}take(e){this.types=e,this.root.dataset.count=String(e.length),[...this.root.children].forEach((t,n)=>t.querySelector(".enlarge").addEventListener("click",()=>this.enlarge(n,!0))),this.large=0,this.mark()}get named(){return this.large?this.types[this.large]:null}enlarge(e,t=!1){let n=typeof e=="number"?e:this.types.indexOf(e);return n<0?!1:(this.large=n,this.mark(),t&&this.root.children[n].querySelector("canvas").focus({preventScroll:!0}),this.changed(),!0)}mark(){[...this.root.children].forEach((e,t)=>e.classList.toggle("large",t===this.large))}},ju=class{constructor(e){this.elements=e,window.addEventListener("resize",()=>this.release())}keep(){for(let e of this.elements){let{height:t}=e.getBoundingClientRect();t>parseFloat(e.style.minHeight||0)&&(e.style.minHeight=`${t}px`)}}release(){for(let e of this.elements)e.style.minHeight=""}};var Yx=new yn,Ku=new C,Bs=class extends ua{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new tt(e,3)),this.setAttribute("uv",new tt(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new Ms(t,6,1);return this.setAttribute("instanceStart",new Kn(n,3,0)),this.setAttribute("instanceEnd",new Kn(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new Ms(t,6,1);return this.setAttribute("instanceColorStart",new Kn(n,3,0)),this.setAttribute("instanceColorEnd",new Kn(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new ta(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new yn);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),Yx.setFromBufferAttribute(t),this.boundingBox.union(Yx))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Cn),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Ku.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Ku)),Ku.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Ku));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};fe.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Ge},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};Mn.line={uniforms:Ma.merge([fe.common,fe.fog,fe.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var ks=class extends Qn{constructor(e){super({type:"LineMaterial",uniforms:Ma.clone(Mn.line.uniforms),vertexShader:Mn.line.vertexShader,fragmentShader:Mn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var zf=new at,Zx=new C,jx=new C,rn=new at,on=new at,Li=new at,Gf=new C,Vf=new Qe,an=new ha,Kx=new C,Ju=new yn,Qu=new Cn,Ni=new at,Di,cr;function Jx(i,e,t){return Ni.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),Ni.multiplyScalar(1/Ni.w),Ni.x=cr/t.width,Ni.y=cr/t.height,Ni.applyMatrix4(i.projectionMatrixInverse),Ni.multiplyScalar(1/Ni.w),Math.abs(Math.max(Ni.x,Ni.y))}function JC(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){an.start.fromBufferAttribute(s,a),an.end.fromBufferAttribute(r,a),an.applyMatrix4(t);let c=new C,u=new C;Di.distanceSqToSegment(an.start,an.end,u,c),u.distanceTo(c)<cr*.5&&e.push({point:u,pointOnLine:c,distance:Di.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function QC(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-e.near;Di.at(1,Li),Li.w=1,Li.applyMatrix4(e.matrixWorldInverse),Li.applyMatrix4(n),Li.multiplyScalar(1/Li.w),Li.x*=r.x/2,Li.y*=r.y/2,Li.z=0,Gf.copy(Li),Vf.multiplyMatrices(e.matrixWorldInverse,o);for(let d=0,f=u;d<f;d++){if(rn.fromBufferAttribute(l,d),on.fromBufferAttribute(c,d),rn.w=1,on.w=1,rn.applyMatrix4(Vf),on.applyMatrix4(Vf),rn.z>h&&on.z>h)continue;if(rn.z>h){let v=rn.z-on.z,M=(rn.z-h)/v;rn.lerp(on,M)}else if(on.z>h){let v=on.z-rn.z,M=(on.z-h)/v;on.lerp(rn,M)}rn.applyMatrix4(n),on.applyMatrix4(n),rn.multiplyScalar(1/rn.w),on.multiplyScalar(1/on.w),rn.x*=r.x/2,rn.y*=r.y/2,on.x*=r.x/2,on.y*=r.y/2,an.start.copy(rn),an.start.z=0,an.end.copy(on),an.end.z=0;let g=an.closestPointToPointParameter(Gf,!0);an.at(g,Kx);let m=eu.lerp(rn.z,on.z,g),x=m>=-1&&m<=1,y=Gf.distanceTo(Kx)<cr*.5;if(x&&y){an.start.fromBufferAttribute(l,d),an.end.fromBufferAttribute(c,d),an.start.applyMatrix4(o),an.end.applyMatrix4(o);let v=new C,M=new C;Di.distanceSqToSegment(an.start,an.end,M,v),t.push({point:M,pointOnLine:v,distance:Di.origin.distanceTo(M),object:i,face:null,faceIndex:d,uv:null,uv1:null})}}}var go=class extends $e{constructor(e=new Bs,t=new ks({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)Zx.fromBufferAttribute(t,o),jx.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+Zx.distanceTo(jx);let r=new Ms(s,2,1);return e.setAttribute("instanceDistanceStart",new Kn(r,1,0)),e.setAttribute("instanceDistanceEnd",new Kn(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;Di=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;cr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Qu.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=cr*.5;else{let h=Math.max(s.near,Qu.distanceToPoint(Di.origin));c=Jx(s,h,l.resolution)}if(Qu.radius+=c,Di.intersectsSphere(Qu)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Ju.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=cr*.5;else{let h=Math.max(s.near,Ju.distanceToPoint(Di.origin));u=Jx(s,h,l.resolution)}Ju.expandByScalar(u),Di.intersectsBox(Ju)!==!1&&(n?JC(this,t):QC(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(zf),this.material.uniforms.resolution.value.set(zf.z,zf.w))}};var xo=class extends Bs{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setPositions(n),this}setColors(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setColors(n),this}setFromPoints(e){let t=e.length-1,n=new Float32Array(6*t);for(let s=0;s<t;s++)n[6*s]=e[s].x,n[6*s+1]=e[s].y,n[6*s+2]=e[s].z||0,n[6*s+3]=e[s+1].x,n[6*s+4]=e[s+1].y,n[6*s+5]=e[s+1].z||0;return super.setPositions(n),this}fromLine(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}};var eh=class extends go{constructor(e=new xo,t=new ks({color:Math.random()*16777215})){super(e,t),this.isLine2=!0,this.type="Line2"}};function Qx(i,e=Math.PI/3){let t=i.index?i.toNonIndexed():i,n=t.attributes.position,s=n.count,r;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)r=n.array;else{r=new Float64Array(s*3);for(let M=0;M<s;M++)r[3*M+0]=n.getX(M),r[3*M+1]=n.getY(M),r[3*M+2]=n.getZ(M)}let o=Math.cos(e),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let M=0;M<l;M++){let w=9*M,A=r[w+0],_=r[w+1],b=r[w+2],I=r[w+3],T=r[w+4],L=r[w+5],D=r[w+6],O=r[w+7],P=r[w+8],B=D-I,H=O-T,V=P-L,ee=A-I,X=_-T,j=b-L,te=H*j-V*X,ve=V*ee-B*j,Pe=B*X-H*ee,Y=1/(Math.sqrt(te*te+ve*ve+Pe*Pe)||1);c[3*M+0]=te*Y,c[3*M+1]=ve*Y,c[3*M+2]=Pe*Y}let u=new Int32Array(s),h=new Float64Array(s*3),d=1;for(;d<s*2;)d<<=1;let f=d-1,p=new Int32Array(d),g=0;for(let M=0;M<s;M++){let w=3*M,A=Math.trunc(r[w+0]*a),_=Math.trunc(r[w+1]*a),b=Math.trunc(r[w+2]*a),I=(Math.imul(A,73856093)^Math.imul(_,19349663)^Math.imul(b,83492791))&f;for(;;){let T=p[I];if(T===0){let D=3*g;h[D+0]=A,h[D+1]=_,h[D+2]=b,p[I]=g+1,u[M]=g++;break}let L=3*(T-1);if(h[L+0]===A&&h[L+1]===_&&h[L+2]===b){u[M]=T-1;break}I=I+1&f}}let m=new Int32Array(g+1);for(let M=0;M<s;M++)m[u[M]+1]++;for(let M=0;M<g;M++)m[M+1]+=m[M];let x=new Int32Array(s),y=m.slice(0,g);for(let M=0;M<l;M++){let w=3*M;x[y[u[w+0]]++]=M,x[y[u[w+1]]++]=M,x[y[u[w+2]]++]=M}let v=new Float32Array(s*3);for(let M=0;M<l;M++){let w=3*M,A=c[w+0],_=c[w+1],b=c[w+2];for(let I=0;I<3;I++){let T=w+I,L=u[T],D=0,O=0,P=0;for(let H=m[L],V=m[L+1];H<V;H++){let ee=3*x[H],X=c[ee+0],j=c[ee+1],te=c[ee+2];A*X+_*j+b*te>o&&(D+=X,O+=j,P+=te)}let B=1/(Math.sqrt(D*D+O*O+P*P)||1);v[3*T+0]=D*B,v[3*T+1]=O*B,v[3*T+2]=P*B}}return t.setAttribute("normal",new Ct(v,3,!1)),t}var ty=new C(0,1,0),Hf=.995,e3=.6,th=2*Math.PI,Qi=64,ny=(i,e,t)=>new ks({color:new Fe(i),linewidth:e,transparent:t<1,opacity:t,alphaToCoverage:!1});function jt(i,e,t,n=1){let s=new eh(new xo,ny(e,t,n));return s.geometry.setPositions(i.length>3?i:[...i,...i]),s.frustumCulled=!1,s}var es=(i,e,t=1)=>iy(new Gr,i,e,t);function iy(i,e,t,n){return i.geometry.setAttribute("position",new Ct(Float32Array.from(e),3)),i.material=new gs({color:t,transparent:n<1,opacity:n}),i.frustumCulled=!1,i}function Wf(i,e){i.geometry.instanceCount=Math.max(0,e),i.visible=e>0}function yo(i,e,t,n=1){if(t<=1)return iy(new Js,i,e,n);let s=new go(new Bs,ny(e,t,n));return s.geometry.setPositions(i),s.frustumCulled=!1,s}var ts=(i,e,t,n)=>i.joined?jt(e,t,n):ur(e,t,n);function ns(i,e,t){i.joined?Wf(e,t):e.geometry.setDrawRange(0,t+1)}function ur(i,e,t){let n=new xt;n.setAttribute("position",new Ct(Float32Array.from(i),3));let s=new Zo(n,new Vr({color:e,size:t,sizeAttenuation:!1}));return s.frustumCulled=!1,s}function Ui(i,e,t,n=1){let s=[];for(let r=0;r<=128;r++)s.push(i*Math.cos(th*r/128),i*Math.sin(th*r/128),e);return n>1?jt(s,t,n):es(s,t)}function hr(i,e){let t=new _n({color:i}),n=new $e(new ci(e,e,1,16),t),s=new $e(new xs(3*e,8*e,24),t),r=new ut().add(n,s);return r.point=(o,a)=>{let l=Math.max(a-8*e,1e-6);r.visible=a>.001,n.scale.set(1,l,1),n.position.set(0,.5*l,0),s.position.set(0,a-4*e,0),r.quaternion.copy(new ot().setFromUnitVectors(ty,o.clone().normalize())),r.userData.tip=o.clone().normalize().multiplyScalar(a)},r}function zs(i,e,t){let n=new $e(new On(t,24,16),new dn({color:i})),s=new $e(new On(1.35*t,24,16),new dn({color:e,side:1}));return new ut().add(n,s)}function sy(i,e,t,n){let s=new $e(new xs(.45*n,n,16),new dn({color:i}));return s.position.copy(e).multiplyScalar(1.003),s.quaternion.setFromUnitVectors(ty,t),s}var ey={stable:()=>new On(.045,20,14),unstable:()=>new Qo(.06),undecided:()=>new $i(.075,.075,.075)};function ry(i,e,t,n){let s=new $e(ey[e](),new dn({color:t})),r=new $e(ey[e](),new dn({color:n,side:1}));r.scale.setScalar(1.3);let o=new ut().add(s,r);return o.position.copy(i),o}var Ha=null;function t3(){if(Ha)return Ha;let i=new Uint8Array(4*Qi*Qi);for(let e=0;e<Qi;e++)for(let t=0;t<Qi;t++){let[n,s]=[2*t/(Qi-1)-1,2*e/(Qi-1)-1],r=Math.exp(-12*((n+.35)**2+(s-.45)**2)),o=.62+.3*Math.tanh(2.5*s)-.3*Math.exp(-18*(s+.1)**2),a=Math.round(255*Math.min(1,Math.max(.12,o+.5*r)));i.set([a,a,a,255],4*(Qi*e+t))}return Ha=new li(i,Qi,Qi),Ha.needsUpdate=!0,Ha}function oy(i,e,t,n,s=null,r=!1){let o=new xt;if(o.setAttribute("position",new Ct(Float32Array.from(i),3)),o.setIndex(new Ct(e,1)),s){let h=[...s].flatMap(d=>new Fe(d).toArray());o.setAttribute("color",new Ct(Float32Array.from(h),3))}let a=Qx(o,e3),l={color:s?"#ffffff":t,vertexColors:!!s,side:2,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1},c=r?new ia({...l,matcap:t3()}):new _n(l),u=new Js(new Hr(o,30),new gs({color:n,transparent:!0,opacity:.6}));return new ut().add(new $e(a,c),u)}function ay(i,e,t){let n=new $i(...i),s=new _n({color:e,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),r=new Js(new Hr(n),new gs({color:t,transparent:!0,opacity:.6}));return new ut().add(new $e(n,s),r)}function Wa(i,e,t,n=1){let s=new _n({color:e,transparent:n<1,opacity:n,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),r=new $e(new On(1,80,48),s);r.scale.set(...i);let o=new ut().add(r);for(let a=0;a<3;a++){let l=[];for(let c=0;c<=128;c++){let u=[0,0,0];u[(a+1)%3]=i[(a+1)%3]*Math.cos(th*c/128),u[(a+2)%3]=i[(a+2)%3]*Math.sin(th*c/128),l.push(...u)}o.add(es(l,t,.7))}return o.userData.mesh=r,o}function ly(i,e,t){let n=new xt,s=new Float32Array(3*Math.max(0,i.length-3));for(let a=0;a+5<i.length;a+=3)s.set(i.slice(a,a+6),3*a+3);n.setAttribute("position",new Ct(s,3));let r=new dn({color:e,transparent:!0,opacity:t,side:2,depthWrite:!1}),o=new $e(n,r);return o.frustumCulled=!1,o.renderOrder=2,o}function _o(i){let e=new _n({color:i.sphere,transparent:!0,opacity:.8,depthWrite:!0}),t=new $e(new On(Hf,80,48),e);return t.renderOrder=1,t}function vo(i,e,t,n=4){let s=new ci(i,i,1e-4,96);s.rotateX(Math.PI/2);let r=new dn({color:t.plane,transparent:!0,opacity:.75,polygonOffset:!0,polygonOffsetFactor:2,polygonOffsetUnits:2}),o=new $e(s,r),a=new ut().add(o);for(let l=1;l<=n;l++)a.add(Ui(i*l/n,0,t.ring));return a.position.set(0,0,e),a.userData.mesh=o,a}function cy(i){i.traverse(e=>{e.geometry?.dispose();for(let t of[e.material].flat())t?.dispose()})}var n3=17,i3=200,s3=2,nh=class{constructor(e){this.view=e,this.renderer=new su({antialias:!0,alpha:!0,powerPreference:"low-power"}),this.renderer.setClearColor(0,0),this.size=[0,0]}draw(e,t,n){let s=Math.min(window.devicePixelRatio||1,s3),r=t.map(l=>[l.clientWidth,l.clientHeight]);this.fit(r.reduce((l,[c])=>l+c,0),Math.max(...r.map(([,l])=>l)),s);let o=0,a=e.map((l,c)=>{let[u,h]=r[c];return u&&h&&this.render(l,o,u,h),o+=u,o-u});e.forEach((l,c)=>this.copy(l,t[c],a[c],r[c],s,n))}render(e,t,n,s){let{renderer:r}=this;e.flat?a3(e.camera,e.flat,n/s):this.view.place(e.camera,e.target??jd,e.radius,n/s),e.lamp.position.copy(e.camera.position).add(l3.clone().applyQuaternion(e.camera.quaternion)),e.lamp.target.position.copy(e.target??jd),e.lamp.target.updateMatrixWorld(),r.setViewport(t,0,n,s),r.setScissor(t,0,n,s),r.setScissorTest(!0),r.render(e.scene,e.camera)}copy(e,t,n,[s,r],o,a){let[l,c]=[Math.round(s*o),Math.round(r*o)];if(!l||!c)return;(t.width!==l||t.height!==c)&&([t.width,t.height]=[l,c]);let u=t.getContext("2d"),h=this.renderer.domElement;u.clearRect(0,0,l,c),u.drawImage(h,n*o,h.height-c,l,c,0,0,l,c),this.write(e,u,l,c,o,a)}fit(e,t,n){let s=[Math.max(this.size[0],e),Math.max(this.size[1],t)];this.dots===n&&s[0]===this.size[0]&&s[1]===this.size[1]||([this.size,this.dots]=[s,n],this.renderer.setPixelRatio(n),this.renderer.setSize(...s,!1))}write(e,t,n,s,r,o){if(e.boxes=[],Math.min(n,s)<i3*r)return;t.font=`600 ${13*r}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.lineJoin="round";let a=[];for(let{text:l,place:c,color:u}of e.labels()){let h=W(l),d=c.clone().project(e.camera),f=[t.measureText(h).width+4*r,n3*r],p=[.5*(1+d.x)*n,.5*(1-d.y)*s],g=o3(p,f,a,[n,s]);a.push(g);let[m,x]=[g[0]+.5*f[0],g[1]+.5*f[1]];t.lineWidth=4*r,t.strokeStyle=o.ground,t.strokeText(h,m,x),t.fillStyle=u,t.fillText(h,m,x)}e.boxes=a.map(l=>l.map(c=>c/r))}},uy=[[0,0],[1,0],[-1,0],[0,-1],[0,1],[1,-1],[-1,-1],[1,1],[-1,1]],r3=4;function o3([i,e],[t,n],s,[r,o]){let a=(u,h,d)=>Math.min(Math.max(u,0),Math.max(0,d-h)),l=([u,h])=>s.every(([d,f,p,g])=>u>=d+p||d>=u+t||h>=f+g||f>=h+n),c=null;for(let u=0;u<=r3;u++)for(let[h,d]of u?uy.slice(1):uy.slice(0,1)){let f=a(i-.5*t+u*h*.55*t,t,r),p=a(e-.5*n+u*d*.55*n,n,o);if(c??=[f,p],l([f,p]))return[f,p,t,n]}return[...c,t,n]}function a3(i,{wide:e,high:t,x:n=0},s){let r=Math.max(t,e/s)/Math.tan(cu*Math.PI/360);i.position.set(n,0,r),i.up.set(0,1,0),i.aspect=s,i.near=r/2,i.far=2*r,i.lookAt(n,0,0),i.updateProjectionMatrix(),i.updateMatrixWorld()}var l3=new C(-2,3,1);function Vn(i,e){let t=new Wo,n=new la(16777215,2.1*i.lamp);return t.add(new ca(16777215,1.3*i.lamp),n,n.target),{scene:t,lamp:n,camera:Bg(),radius:1.5,labels:()=>[],probe:()=>({}),...e}}function hy(i,e,t){let n=e.center?"from the pivot towards the centre of mass":"third principal axis",s=Vn(t,{title:"Path of the axis",words:n,radius:1.4,target:new C(0,0,.12)}),{scene:r}=s,o=new C(...e.axis),a=i.solver?.nutationLimits??null,l=a?a.filter(p=>p!==null&&Math.abs(p)<1):e.limits;r.add(_o(t),Ui(1,0,t.family));for(let p of l)r.add(Ui(Math.sqrt(Math.max(0,1-p*p)),p,t.border,1.5));let c=new Float64Array(3*i.count);for(let p=0;p<i.count;p++)o.clone().applyQuaternion(i.attitude(p)).toArray(c,3*p);let u=ts(i,c,t.motion,2.6),h=i.joined?es(c,t.motion,.35):null,d=zs(t.motion,t.ground,.035),f=hr(t.momentum,.012);return f.position.set(0,0,1),f.point(new C(0,0,1),.32),r.add(u,d,f),h&&r.add(h),s.legend=[{color:t.motion,text:"axis"},...l.length?[{color:t.border,text:"limits of its tilt"}]:[]],s.update=p=>{d.position.copy(o).applyQuaternion(p.attitude),ns(i,u,Math.floor(p.position))},s.labels=()=>[{text:"up",color:t.momentum,place:new C(0,0,1.42)}],s.probe=()=>({point:d.position.toArray(),path:[...c],limits:l}),s}var[dy,c3,u3]=[.45,.14,1.2],qf=6,h3=.45,fy=new C(0,1,0);function py(i,e,t){let n=new C(...i.solver?.axis||e.axis).normalize(),s=new ut;for(let d=0;d<qf;d++){let f=new ci(dy,dy,c3,12,1,!1,2*Math.PI*d/qf,2*Math.PI/qf),p=new _n({color:t.rotor});d%2&&p.color.multiplyScalar(h3),s.add(new $e(f,p))}let r=new ot().setFromUnitVectors(fy,n),o=n.clone().multiplyScalar(u3).toArray(),a=new ut().add(s,jt([...o.map(d=>-d),...o],t.rotor,2)),l=d3(i,e),c=l&&f3(i.times,l),u=(d,{position:f})=>{let p=Math.min(Math.floor(f),d.length-2);return p<0?d[0]:d[p]+(f-p)*(d[p+1]-d[p])};return{object:a,turn:d=>{let f=c?u(c,d):0;s.quaternion.copy(r).multiply(new ot().setFromAxisAngle(fy,f))},rate:d=>l?u(l,d):null}}function d3(i,e){let t=i.solver;if(!t?.rotorRate)return ht(e.rates);if(t.rotorMoment===null)return null;let n=s=>[0,1,2].map(r=>i.velocities[3*s+r]);return Float64Array.from({length:i.count},(s,r)=>t.rotorRate(n(r))??0)}function f3(i,e){let t=new Float64Array(e.length);for(let n=1;n<e.length;n++)t[n]=t[n-1]+.5*(e[n]+e[n-1])*(i[n]-i[n-1]);return t}var p3=.035;function my({cage:{radius:i,center:e}},t){let n=new ut,s=new na({color:t.edge,specular:"#ffffff",shininess:60}),r=()=>new $e(new ea(i,p3*i,12,96),s),[o,a]=[r(),r()];o.rotation.y=Math.PI/2;for(let c of[o,a])c.position.z=e;return n.add(o,a),{object:n,turn:c=>{let u=c.clone().normalize(),h=new C(0,0,1).cross(u),d=h.lengthSq()>1e-12?h.normalize():new C(0,1,0);n.quaternion.setFromRotationMatrix(new Qe().makeBasis(d,u.clone().cross(d),u)),n.updateMatrix()}}}var gy=2*Math.PI,xy=1200,m3=.35,g3=.02,x3=Math.PI/4;function yy(i,e,t,n=.22){let s=y3(i,e),r=[];for(let l=0;l<s.length;l+=3)r.push(new C().fromArray(s,l).angleTo(e));let[o,a]=[Math.min(...r),Math.max(...r)];return!(a>g3)||s.length<9?null:{object:new ut().add(ly(s,t,n),jt(s,t,1.5)),halves:[o,a]}}function y3(i,e){let n=(Math.abs(e.z)<.9?new C(0,0,1):new C(1,0,0)).clone().cross(e).normalize(),s=e.clone().cross(n),r=[],[o,a]=[0,null],l=Math.max(1,Math.floor(i.length/3/(20*xy)));for(let d=0;d<i.length&&Math.abs(o)<gy;d+=3*l){let f=new C().fromArray(i,d),p=Math.atan2(f.dot(s),f.dot(n));a!==null&&(o+=Math.atan2(Math.sin(p-a),Math.cos(p-a))),a=p,r.push(...f.toArray())}let c=_3(r,Math.ceil(r.length/3/xy)),u=new C().fromArray(c,0).distanceTo(new C().fromArray(c,c.length-3)),h=v3(c);return Math.abs(o)>=gy-1e-9&&u<Math.max(m3,2)*h&&c.push(...c.slice(0,3)),c}function _3(i,e){if(e<=1)return i;let t=[];for(let n=0;n<i.length;n+=3*e)t.push(...i.slice(n,n+3));return t}function v3(i){let e=0;for(let t=3;t<i.length;t+=3)e+=Math.hypot(...[0,1,2].map(n=>i[t+n]-i[t-3+n]));return e/Math.max(1,i.length/3-1)}function Xf(i,e){if(!i.free||!i.momenta)return!1;for(let t=0;t<i.count;t++){let n=new C().fromArray(i.momenta,3*t);if(!(Math.atan2(n.clone().cross(e).length(),Math.abs(n.dot(e)))<x3))return!1}return!0}function _y(i,e,t){let n={space:[],body:[],axis:[]};for(let s=0;s<i.count;s++){let r=i.attitude(s);if(n.axis.push(...t.clone().applyQuaternion(r).applyQuaternion(i.space).toArray()),!i.velocities)continue;let o=new C().fromArray(i.velocities,3*s).multiplyScalar(e);n.body.push(...o.toArray()),n.space.push(...o.applyQuaternion(r).applyQuaternion(i.space).toArray())}return n}var $f=1.36,[M3,b3]=[.6,.85],vy=new C(0,0,-1);function by(i,e,t){let n=S3(i.momenta),s=[],r=(c,u,h,d,f,p=1.1)=>s.push({entry:Qr(c,h,u),text:c,arrow:hr(h,d),lengthOf:f,label:p,from:null});if(i.momenta&&r("L","L",t.momentum,.02,c=>My(i,c.momentum,c,$f/n),1.08),i.velocities&&r("\u03A9","\u03A9",t.velocity,.017,c=>My(i,c.velocity,c,$f/i.fastest),1.16),e){let c=new C(...e),u=d=>c.clone().applyQuaternion(d.attitude).applyQuaternion(i.space),h=c.length();r("mg","weight mg",t.weight,.017,()=>vy.clone().multiplyScalar(M3)),s.at(-1).from=u,r("\u03C4","torque of the weight, dL/dt",t.torque,.017,d=>u(d).cross(vy).multiplyScalar(b3/h))}let o=c=>{for(let u of s){let h=u.lengthOf(c),d=As(u.entry)&&Number.isFinite(h.lengthSq())?h.length():0;d>0?u.arrow.point(h,d):u.arrow.visible=!1,u.from&&u.arrow.position.copy(u.from(c))}},a=()=>s.filter(c=>c.arrow.visible).map(c=>({text:c.text,color:c.entry.color,place:c.arrow.userData.tip.clone().multiplyScalar(c.label).add(c.arrow.position)})),l=()=>Object.fromEntries(s.map(c=>[c.text,c.arrow.visible?{tip:c.arrow.userData.tip.toArray(),from:c.arrow.position.toArray()}:null]));return{objects:s.map(c=>c.arrow),entries:s.map(c=>c.entry),show:o,labels:a,probe:l}}var My=(i,e,t,n)=>e.clone().applyQuaternion(t.attitude).applyQuaternion(i.space).multiplyScalar(Number.isFinite(n)?n:0),Sy=i=>i.fastest?$f/i.fastest:0;function S3(i){let e=0;for(let t=0;i&&t<i.length;t+=3)e=Math.max(e,Math.hypot(i[t],i[t+1],i[t+2]));return e}var Gs=1.22,w3={ground:0,post:-Gs,hook:Gs},A3=.4,E3=.35,T3=.06;function wy(i,e,t){let n=e.pivot&&i.solver?{...e,pivot:L3(i,e.pivot)}:e,s=Vn(t,{title:"The body in space",words:n.changed?"box or ellipsoid of the same inertia":n.shape,radius:n.pivot==="ground"?1.5:1.62});n.pivot||(s.target=new C(0,0,.08)),n.pivot==="ground"&&(s.target=new C(0,0,.42));let r=new ut;r.quaternion.copy(i.space),s.scene.add(r);let o=N3(i,n,t);r.add(o);let a=n.rotor?py(i,n.rotor,t):null;a&&(R3(o),o.add(a.object));let l=[0,1,2].map(x=>{let y=new C().setComponent(x,Gs);return o.add(jt([0,0,0,...y.toArray()],t.axes[x],x===n.traced&&!n.along?2.5:1.5)),y}),c=t.axes[n.traced],h=(n.along?new C(...n.along):new C().setComponent(n.traced,1)).multiplyScalar(Gs);n.along&&o.add(jt([0,0,0,...h.toArray()],c,2.5));let d=F3(i,h,c);r.add(d.object),n.pivot?s.scene.add(vo(n.pivot==="ground"?Gs:.7,w3[n.pivot],t)):s.scene.add(Ui(Gs,0,t.ring)),n.pivot==="post"&&s.scene.add(jt([0,0,-Gs,0,0,0],t.edge,5)),n.pivot==="hook"&&s.scene.add(jt([0,0,0,0,0,Gs],t.edge,5));let f=by(i,n.weight?C3(n,h):null,t),p=I3(i,h,n,c,t),g=n.cage&&!n.changed?my(n,t):null;g&&s.scene.add(g.object);for(let x of f.objects)s.scene.add(x);for(let x of p)(x.inBody?o:s.scene).add(x.object);let m=null;return s.legend=[{color:c,text:n.along?"trace of the axis through the centre of mass":W("trace of axis {axis}",{axis:n.axes?.[n.traced]??n.traced+1})},...f.entries,...p.map(({entry:x})=>x),...a?[{color:t.rotor,text:P3(a.rate({position:0}))}]:[]],s.update=x=>{m=x,o.quaternion.copy(x.attitude),d.show(x.position),a?.turn(x),f.show(x),g?.turn(h.clone().applyQuaternion(x.attitude).applyQuaternion(i.space));for(let y of p)y.object.visible=As(y.entry)},s.labels=()=>[...l.map((x,y)=>({text:n.axes?.[y]??`${y+1}`,color:t.axes[y],place:x.clone().multiplyScalar(1.07).applyQuaternion(m.attitude).applyQuaternion(i.space)})),...f.labels()],s.probe=()=>(o.updateWorldMatrix(!0,!1),{matrix:[...o.matrixWorld.elements],axisTip:h.clone().applyMatrix4(o.matrixWorld).toArray(),trace:[...d.points].slice(0,3*(d.shown+1)),momentumTip:f.probe().L?.tip??null,vectors:f.probe(),cage:g?g.object.matrix.elements.slice():null,cones:Object.fromEntries(p.map(({entry:x,halves:y,object:v})=>[x.key,{halves:y,shown:v.visible}])),rotor:a?[...a.object.children[0].quaternion.toArray(),a.rate(m)]:null}),s}function R3(i){i.traverse(e=>{e.isMesh&&(Object.assign(e.material,{transparent:!0,opacity:E3,depthWrite:!1}),e.renderOrder=1)})}var C3=({weight:i},e)=>e.clone().normalize().multiplyScalar(i.center).toArray();function I3(i,e,t,n,s){if(!i.joined||!i.attitudes||i.count<3)return[];let o=[0,1,2].map(h=>new C().setComponent(h,1)).find(h=>Xf(i,h))??null,a=Xf(i,e.clone().normalize()),l=_y(i,Sy(i),e),c=new C(0,0,1),u=o??e.clone().normalize();return l.body.length&&new C().fromArray(l.body).dot(u)<0&&u.negate(),[{key:"space cone",text:t.pivot?"cone of \u03A9 in space":"cone of \u03A9 about L (space cone)",rays:l.space,about:c,tint:s.herpolhode},{key:"body cone",text:"cone of \u03A9 in the body",rays:l.body,about:u,tint:s.bodyCone,inBody:!0},{key:"axis cone",text:"cone of the axis",rays:l.axis,about:c,tint:n}].flatMap(({key:h,text:d,rays:f,about:p,tint:g,inBody:m=!1})=>{let x=yy(f,p,g);return x?[{...x,inBody:m,entry:Qr(h,g,d,h==="axis cone"?a:o!==null)}]:[]})}function P3(i){return i===null?"rotor, drawn at rest: its moment is not given":W("rotor, {rate} against the body",{rate:fi(i)})}function L3(i,e){let t=[];for(let n=0;n<i.count;n++)t.push(new C(0,0,1).applyQuaternion(i.attitude(n)).z);return t.reduce((n,s)=>n+s,0)<0?"hook":e!=="ground"||Math.min(...t)<A3?"post":"ground"}function N3(i,e,t){let n=new ut,s=e.changed&&i.free?U3(i.free):null;if(s&&e.round)return n.add(Wa(s.map(r=>.5*r),t.body,t.edge));if(e.changed&&!s&&i.moments&&(e={ellipsoid:i.moments.map(r=>1/Math.sqrt(r))}),s)return n.add(ay(s,t.body,t.edge));if(e.surface){let r=ht(e.surface.vertices),o=D3(r),{faces:a,colors:l,shiny:c=!1,lines:u=[]}=e.surface;n.add(oy(r.map(h=>h/o),ht(a),t.body,t.edge,ht(l),c));for(let{points:h,color:d,width:f}of u){let p=[...ht(h)].map(m=>m/o),g=`#${d.toString(16).padStart(6,"0")}`;n.add(f>1?jt(p,g,f):es(p,g))}}else if(e.ellipsoid){let r=Math.max(...e.ellipsoid);n.add(Wa(e.ellipsoid.map(o=>o/r),t.body,t.edge))}return n}function D3(i){let e=0;for(let t=0;t<i.length;t+=3)e=Math.max(e,Math.hypot(i[t],i[t+1],i[t+2]));return e}function U3([i,e,t]){let n=[e+t-i,t+i-e,i+e-t],s=i+e+t;return n.some(r=>r<1e-9*s)?null:n.map(r=>2*Math.sqrt(r/s))}function F3(i,e,t){let n=[],s=[],r=l=>n.push(...e.clone().applyQuaternion(l).toArray()),o=null;for(let l=0;l<i.count;l++){let c=i.attitude(l);if(o&&i.joined){let u=Math.min(20,Math.ceil(o.angleTo(c)/T3));for(let h=1;h<u;h++)r(i.at(l-1+h/u).attitude)}r(c),s.push(n.length/3-1),o=c}let a={points:n,shown:0};return i.joined?(a.object=jt(n,t,2),a.show=l=>Wf(a.object,a.shown=s[Math.floor(l)])):(a.object=ur(n,t,3),a.show=l=>a.object.geometry.setDrawRange(0,(a.shown=Math.floor(l))+1)),a}function Ay(i,e,t){let n=i.at(0).momentum,{free:s}=i;if(!(n.length()>0))return Vn(t,{title:"Poinsot's ellipsoid",words:"at rest",update:()=>{},legend:[]});let r=.5*n.toArray().reduce((T,L,D)=>T+L*L/s[D],0),o=s.map(T=>1/Math.sqrt(T)),a=1/Math.max(...o),l={moments:s,energy:r},c=a*Math.sqrt(2*r)/n.length(),u=B3(i,l,a),h=Math.max(1.25*O3(u,c),.9),d=1.3,f=.5*(d-c),p=Vn(t,{title:"Poinsot's ellipsoid",words:"rolls without slipping on the plane across L",radius:Math.hypot(Math.max(h,1),d-f)*1.04,target:new C(0,0,f)}),g=new ut;g.quaternion.copy(i.space);let m=Wa(o.map(T=>T*a),t.body,t.edge,.82);g.add(m);let x=vo(h,-c,t);p.scene.add(g,x);let y=k3(i,u),v=ts(i,u,t.motion,3),M=ts(i,y,t.herpolhode,2.5);m.add(v),g.add(M),i.joined&&g.add(es(y,t.herpolhode,.45));let w=zs(t.velocity,t.ground,.03),A=hr(t.velocity,.012),_=hr(t.momentum,.012),b=es([0,0,-c,0,0,0],t.edge);g.add(w,A),p.scene.add(_,b),_.point(new C(0,0,1),d);let I=0;return p.legend=[{color:t.motion,text:"polhode"},{color:t.herpolhode,text:"herpolhode"},{color:t.velocity,text:"contact, \u2212\u03A9"}],p.update=T=>{let L=Math.floor(T.position*i.fine);m.quaternion.copy(T.attitude),w.position.copy(Ey(T.momentum,l,a)).applyQuaternion(T.attitude),A.point(w.position,w.position.length()),ns(i,v,L),ns(i,M,L),I=L},p.labels=()=>[{text:"L",color:t.momentum,place:new C(0,0,d+.12)}],p.probe=()=>{for(let T of[m,x,w])T.updateWorldMatrix(!0,!0);return{ellipsoid:[...m.userData.mesh.matrixWorld.elements],plane:[...x.matrixWorld.elements],contact:new C().setFromMatrixPosition(w.matrixWorld).toArray(),bodyMatrix:[...m.matrixWorld.elements],spaceMatrix:[...g.matrixWorld.elements],polhode:[...u],herpolhode:[...y],shown:I/i.fine}},p}function Ey(i,{moments:e,energy:t},n){let s=-n/Math.sqrt(2*t);return new C(...i.toArray().map((r,o)=>s*r/e[o]))}function O3(i,e){let t=0;for(let n=0;n<i.length;n+=3)t=Math.max(t,Math.hypot(i[n],i[n+1],i[n+2]));return Math.sqrt(Math.max(0,t*t-e*e))}function B3(i,e,t){let n=new Float64Array(3*i.states.length);return i.states.forEach(({momentum:s},r)=>Ey(s,e,t).toArray(n,3*r)),n}function k3(i,e){let t=new Float64Array(e.length);return i.states.forEach(({attitude:n},s)=>{new C().fromArray(e,3*s).applyQuaternion(n).toArray(t,3*s)}),t}var z3=.45,[ih,Vs]=[72,144],Yf=1.32,G3=1.05,V3=2*Math.PI;function Ty(i,e,t){let n=i.free??(i.solver?.mgl===void 0?i.solver?.moments:null);if(!n||e.families||!(i.at(0).momentum.length()>0))return null;let s=i.solver?.rotor??[0,0,0];if(Math.max(...n)<G3*Math.min(...n)&&!s.some(Boolean))return null;let r=new _n({color:t.energy,transparent:!0,opacity:z3,side:2,depthWrite:!1}),o=new $e(W3(),r);o.renderOrder=2,o.frustumCulled=!1;let a=Qr("energy",t.energy,"ellipsoid of the same energy",!1),l=null;return{object:o,entry:a,show:u=>{if(o.visible=As(a)&&u.momentum.length()>0,!o.visible)return!1;let h=H3(n,s,u.momentum);return String([h.axes,h.center])!==String(l&&[l.axes,l.center])&&q3(o.geometry,h),l=h,!0},probe:()=>({...l,shown:o.visible,corners:[...o.geometry.attributes.position.array]})}}function H3(i,e,t){let n=t.length(),s=t.toArray().reduce((r,o,a)=>r+(o-e[a])**2/i[a],0);return{axes:i.map(r=>Math.sqrt(s*r)/n),center:e.map(r=>r/n)}}function W3(){let i=new xt;for(let e of["position","normal"])i.setAttribute(e,new Ct(new Float32Array(3*(ih+1)*(Vs+1)),3));return i}function q3(i,{axes:e,center:t}){let{position:n,normal:s}=i.attributes,r=!t.some(Boolean),o=[];for(let l=0;l<=ih;l++)for(let c=0;c<=Vs;c++){let[u,h]=[Math.PI*l/ih,V3*c/Vs],d=[Math.sin(u)*Math.cos(h),Math.sin(u)*Math.sin(h),Math.cos(u)],f=r?1/Math.hypot(...d.map((y,v)=>y/e[v])):0,p=d.map((y,v)=>r?Math.min(f,Yf)*y:t[v]+e[v]*y),g=p.map((y,v)=>(y-t[v])/e[v]**2),m=Math.hypot(...g)||1,x=l*(Vs+1)+c;n.setXYZ(x,...p.map(y=>Hf*y)),s.setXYZ(x,...g.map(y=>y/m)),o.push(r?f<=Yf:Math.hypot(...p)<=Yf)}let a=[];for(let l=0;l<ih;l++)for(let c=0;c<Vs;c++){let u=l*(Vs+1)+c,[h,d,f]=[u+1,u+Vs+2,u+Vs+1];[u,h,d,f][r?"some":"every"](p=>o[p])&&a.push(u,f,d,u,d,h)}i.setIndex(a),n.needsUpdate=!0,s.needsUpdate=!0}var X3=18,$3=1.012,Ry=4,Cy={stable:"stable",unstable:"border",undecided:"undecided"},[Y3,Z3]=[.8,.55],j3={stable:"stable",unstable:"unstable",undecided:"undecided"};function Iy(i,e,t){let n=Vn(t,{title:e.title,words:e.words,radius:1.36}),{scene:s}=n,r=e.families?t.text:t.motion,o=_o(t);s.add(o);let a=i.free?i.at(0).momentum.toArray():null,[l,c]=a?[e.families?[]:f0(i.free),p0(i.free)]:e.changed&&i.solver?[m0(i.moments,i.solver.rotor??[0,0,0],i.at(0).momentum.length()),[]]:[ht(e.family)??[],ht(e.separatrix)??[]];l.length&&s.add(yo(l,t.family,1));for(let{starts:v,axis:M}of e.families??[])s.add(yo(v.flatMap(w=>La(i.free,w)),t.axes[M],1,.75));c.length&&s.add(yo(c,t.border,1.8));let u=a&&Math.hypot(...a)>0?or(i.free,a):null,h=u??K3(i),d=u?jt(u,r,3.2):ts(i,h,r,2);if(s.add(d),u)for(let v of J3(i.free,u,r))s.add(v);let f=e.changed?null:e.measured;f&&s.add(ur(f.map(v=>$3*v),t.velocity,6));let p=zs(r,t.ground,.035);s.add(p);let g=[0,1,2].map(v=>{let M=new C().setComponent(v,1.2);return s.add(jt([...new C().setComponent(v,1).toArray(),...M.toArray()],t.axes[v],2.5)),M}),m=i.free?d0(i.free):e.equilibria??[];for(let{at:v,verdict:M}of m)s.add(ry(new C(...v),M,t[Cy[M]],t.ground));let x=Ty(i,e,t);x&&s.add(x.object);let y=[...new Set(m.map(({verdict:v})=>v))];return n.legend=[{color:r,text:"this motion"},...f?[{color:t.velocity,text:"measured"}]:[],...c.length?[{color:t.border,text:"separatrix"}]:[],...l.length?[{color:t.family,text:e.legend}]:[],...(e.families??[]).map(({axis:v,legend:M})=>({color:t.axes[v],text:M})),...y.map(v=>({color:t[Cy[v]],text:j3[v]})),...x?[x.entry]:[]],n.update=v=>{let M=v.momentum.length();p.visible=M>0,M>0&&p.position.copy(v.momentum).divideScalar(M),u||ns(i,d,Math.floor(v.position*i.fine)),o.material.opacity=x?.show(v)?Z3:Y3},n.labels=()=>g.map((v,M)=>({text:e.axes?.[M]??`L${"\u2081\u2082\u2083"[M]}`,color:t.axes[M],place:v.clone().multiplyScalar(1.08)})),n.grasp=([v,M],w)=>{let A=p.position.clone().project(n.camera),_=p.position.dot(n.camera.position)>1;return i.free&&_&&Math.hypot(A.x-v,A.y-M)*.5*w<X3},n.under=v=>Q3(v,n.camera),n.probe=()=>({point:p.position.toArray(),path:[...h],closed:!!u,measured:f,surface:x?.probe()??null,seen:p.position.clone().project(n.camera).toArray()}),n}function K3(i){let e=new Float64Array(3*i.states.length);return i.states.forEach(({momentum:t},n)=>t.clone().normalize().toArray(e,3*n)),e}function J3(i,e,t){let n=[],s=e.length/3-1;for(let r=0;r<Ry;r++){let o=new C().fromArray(e,3*Math.round((r+.5)/Ry*s)),a=o.clone().cross(new C(...o.toArray().map((l,c)=>l/i[c])));a.length()>0&&n.push(sy(t,o,a.normalize(),.085))}return n}function Q3([i,e],t){let n=t.position.clone(),s=new C(i,e,.5).unproject(t).sub(n).normalize(),r=-n.dot(s),o=n.clone().addScaledVector(s,r),a=o.lengthSq();return a>=1?o.lengthSq()>0?o.normalize().toArray():null:n.addScaledVector(s,r-Math.sqrt(1-a)).normalize().toArray()}var Zf={palette:["#0072B2","#E69F00","#009E73","#D55E00","#56B4E9","#CC79A7"],light:{ground:"#ffffff",text:"#222222",motion:"#0072B2",border:"#D55E00",stable:"#009E73",undecided:"#6f6f6f",family:"#6f6f6f",velocity:"#a8477c",momentum:"#222222",weight:"#6f6f6f",torque:"#6b4fc8",herpolhode:"#a8477c",bodyCone:"#56B4E9",energy:"#d9b800",rotor:"#8c5a2b",ensemble:"#E69F00",classical:"#6f6f6f",axes:["#0072B2","#c78500","#009E73"],sphere:"#eef1f4",body:"#b9c6d3",edge:"#5a6672",plane:"#dfe4e8",ring:"#b4bcc4"},dark:{ground:"#14171b",text:"#e6e6e6",motion:"#56B4E9",border:"#f0803c",stable:"#1fbf92",undecided:"#a0a7ae",family:"#7d848c",velocity:"#CC79A7",momentum:"#f2f2f2",weight:"#a0a7ae",torque:"#a692f0",herpolhode:"#CC79A7",bodyCone:"#9ad4f5",energy:"#F0E442",rotor:"#d29a62",ensemble:"#E69F00",classical:"#a0a7ae",axes:["#56B4E9","#E69F00","#1fbf92"],sphere:"#2a3038",body:"#66727f",edge:"#aab4be",plane:"#2a3038",ring:"#4c5660"}};var Hs={light:{...Zf.light,name:"light",lamp:1},dark:{...Zf.dark,name:"dark",lamp:1.1}},Py=[[],[6,3],[2,2],[8,3,2,3]];function jf(i,e){let t=[i.motion,i.axes[1],i.stable,i.border,i.bodyCone,i.velocity];return{color:t[e%t.length],dash:Py[Math.floor(e/t.length)%Py.length]}}var tI=1600,nI=.05,yt={left:62,right:12,top:10,bottom:24},Mo=180/Math.PI,Ly=[[1/Mo,"\xB0"],[1/Mo/60,"\u2032"],[1/Mo/3600,"\u2033"],[.001/Mo/3600,"mas"]];function iI(i,e,t,n){let s=i.solver?.plots?.(n.map(u=>i.times[u])),r=(u,h,d)=>u.role?{color:t[u.role]}:d?{color:t.axes[h]}:jf(t,h);if(s)return s.map(({series:u,along:h,...d})=>({...d,series:u.map((f,p)=>({...f,...r(f,p,h)}))}));let o=[],a=i.velocities??i.momenta,l=e.axes??["axis 1","axis 2","axis 3"];a&&o.push({title:i.velocities?"\u03A9 along the body's axes":"L along the body's axes",unit:i.velocities?"rad/s":"kg m\xB2/s",series:l.map((u,h)=>({name:u,color:t.axes[h],values:n.map(d=>a[3*d+h])}))});let c=sI(i,e,t,n,l);c&&o.push(c);for(let{title:u,unit:h,series:d}of e.plots??[])o.push({title:u,unit:h,series:d.map(({name:f,values:p},g)=>{let m=ht(p);return{name:f,...jf(t,g),values:n.map(x=>m[x])}})});return o}function sI(i,e,t,n,s){if(!i.attitudes)return null;if(e.up==="L"&&i.momenta){let a=(c,u)=>{let h=i.momenta.subarray(3*c,3*c+3);return Math.atan2(Math.hypot(h[(u+1)%3],h[(u+2)%3]),h[u])*Mo};return{title:"angles of the axes from L",unit:"\xB0",series:s.map((c,u)=>({name:c,color:t.axes[u],values:n.map(h=>a(h,u))}))}}let r=new C(...e.panels.find(a=>a.axis)?.axis??[0,0,1]).normalize(),o=a=>{let[l,c,u,h]=i.attitudes.subarray(4*a,4*a+4),d=r.clone().applyQuaternion(new ot(c,u,h,l));return Math.atan2(Math.hypot(d.x,d.y),d.z)*Mo};return{title:"tilt of the axis from the vertical",unit:"\xB0",series:[{name:"tilt",color:t.motion,values:n.map(o)}]}}var sh=class{constructor(e,t){this.root=e,this.goTo=t,this.plots=[]}take(e,t,n){this.motion=e,this.theme=n;let s=Math.max(1,Math.ceil(e.count/tI)),r=[];for(let l=0;l<e.count;l+=s)r.push(l);r.at(-1)!==e.count-1&&r.push(e.count-1),this.times=r.map(l=>e.times[l]);let o=e.count>1&&e.span>0?iI(e,t,n,r).map(uI):[];for(let{title:l,words:c,x:u,y:h}of t.scatters??[])o.push({title:l,words:c,scatter:[ht(u),ht(h)],color:n.motion});let a=rI(e,n);a&&o.push(a),o.length!==this.plots.length&&(this.root.replaceChildren(...o.map(()=>this.frame())),this.plots=o.map((l,c)=>({figure:this.root.children[c],canvas:this.root.children[c].firstChild}))),this.plots.forEach((l,c)=>{l.what=o[c],l.still=null,lI(l.figure,o[c])})}frame(){let e=document.createElement("figure");e.className="plot";let t=document.createElement("canvas");t.setAttribute("role","img");let n=s=>{if(!this.plots.find(l=>l.canvas===t).what.series||s.type==="pointermove"&&!s.buttons)return;let o=t.getBoundingClientRect(),a=(s.clientX-o.left-yt.left)/(o.width-yt.left-yt.right);this.goTo(this.times[0]+Math.min(1,Math.max(0,a))*(this.times.at(-1)-this.times[0]))};return t.addEventListener("pointerdown",n),t.addEventListener("pointermove",n),e.append(t,document.createElement("figcaption")),e}draw(e){for(let t of this.plots){let{canvas:n,what:s}=t,r=Math.min(window.devicePixelRatio||1,2),[o,a]=[n.clientWidth,n.clientHeight];if(!o||!a)continue;(!t.still||t.width!==o||t.dots!==r)&&(Object.assign(t,{width:o,dots:r,still:this.still(s,o,a,r)}),[n.width,n.height]=[t.still.width,t.still.height]);let l=n.getContext("2d");l.clearRect(0,0,n.width,n.height),l.drawImage(t.still,0,0),l.setTransform(r,0,0,r,0,0),s.path?this.dot(l,s,e,o,a):s.series&&this.cursor(l,e,o,a),l.setTransform(1,0,0,1,0,0)}}still(e,t,n,s){let r=document.createElement("canvas");[r.width,r.height]=[Math.round(t*s),Math.round(n*s)];let o=r.getContext("2d");return o.scale(s,s),o.font="12px system-ui, sans-serif",e.path?aI(o,e,t,n,this.theme):e.scatter?oI(o,e,t,n,this.theme):this.drawCurves(o,e,t,n),r}drawCurves(e,{series:t,unit:n,power:s},r,o){let{times:a,theme:l}=this,[c,u]=Kf(t),h=Dy(a[0],a.at(-1),c,u,r,o);e.fillStyle=l.text,e.strokeStyle=l.ring,e.textBaseline="middle",e.textAlign="right";for(let g of rh(c,u,4)){let[,m]=h(a[0],g);bo(e,[[yt.left,m],[r-yt.right,m]]),e.fillText(`${qa(g/10**s)}${n==="\xB0"?"\xB0":""}`,yt.left-6,m)}e.textBaseline="top",e.textAlign="center";let d=a.at(-1)-a[0],[f,p]=lf(d)??[1,"s"];for(let g of rh(a[0]/f,a.at(-1)/f,r>500?6:3))e.fillText(`${qa(g)} ${p}`,h(g*f,c)[0],o-yt.bottom+7);for(let{color:g,dash:m=[],values:x,times:y=a}of t){[e.strokeStyle,e.fillStyle,e.lineWidth]=[g,g,1.6],e.setLineDash(m);let v=x.map((M,w)=>h(y[w],M));if(this.motion.joined)bo(e,v);else for(let[M,w]of v)e.fillRect(M-1,w-1,2,2)}e.setLineDash([])}cursor(e,t,n,s){let[r,o]=[this.times[0],this.times.at(-1)],a=yt.left+(t.time-r)/(o-r||1)*(n-yt.left-yt.right);e.strokeStyle=this.theme.text,e.lineWidth=1.2,bo(e,[[a,yt.top],[a,s-yt.bottom]])}dot(e,t,n,s,r){let[o,a]=Ny(t,s,r)(t.flat(n.momentum.clone().normalize()));e.fillStyle=this.theme.velocity,e.beginPath(),e.arc(o,a,5,0,2*Math.PI),e.fill()}probe(){return this.plots.map(({what:e})=>({title:e.title,ranges:(e.series??[]).map(({values:t})=>[Math.min(...t),Math.max(...t)]),styles:(e.series??[]).map(({color:t,dash:n=[]})=>({color:t,dash:n})),across:e.across??null}))}};function rI(i,e){if(!i.free)return null;let t=i.at(0).momentum;if(!(t.length()>0))return null;let n=or(i.free,t.toArray()),s=t.clone().normalize().toArray(),r=s.reduce((f,p,g)=>Math.abs(p)>Math.abs(s[f])?g:f,0);if(!n)return null;let o=Math.sign(s[r]),a=f=>[f.getComponent((r+1)%3)*o,f.getComponent((r+2)%3)],l=[];for(let f=0;f<n.length;f+=3)l.push(a(new C(n[f],n[f+1],n[f+2])));let c=Math.max(...l.map(([f,p])=>Math.hypot(f,p)));if(!(c<nI)||c<1e-14)return null;let[u,h]=Ly.find(([f])=>2*c>=f)??Ly.at(-1),d=`${qa(2*c/u,3)}${h.length>1?" ":""}${h}`;return{title:["the polhode from above, {across} across: the sphere magnified {times} times",{across:d,times:et(1/c,1)}],across:d,path:l,flat:a,most:c,color:e.motion,unit:u,name:h}}var Ny=({most:i},e,t)=>{let n=(.5*Math.min(e,t)-22)/i;return([s,r])=>[.5*e+n*s,.5*t-n*r]};function oI(i,{scatter:[e,t],color:n},s,r,o){let[[a,l],[c,u]]=[e,t].map(f=>Kf([{values:f}])),h=Dy(a,l,c,u,s,r);[i.fillStyle,i.textBaseline,i.textAlign]=[o.text,"middle","right"];for(let f of rh(c,u,4))i.fillText(qa(f),yt.left-6,h(a,f)[1]);[i.textBaseline,i.textAlign]=["top","center"];for(let f of rh(a,l,6))i.fillText(qa(f),h(f,c)[0],r-yt.bottom+7);i.strokeStyle=o.ring,i.strokeRect(yt.left,yt.top,s-yt.left-yt.right,r-yt.top-yt.bottom),i.fillStyle=n;let d=e.length<500?3:1.6;for(let f=0;f<e.length;f++){let[p,g]=h(e[f],t[f]);i.fillRect(p-.5*d,g-.5*d,d,d)}}function aI(i,e,t,n,s){let r=Ny(e,t,n);i.strokeStyle=s.ring,bo(i,[[.5*t-8,.5*n],[.5*t+8,.5*n]]),bo(i,[[.5*t,.5*n-8],[.5*t,.5*n+8]]),[i.strokeStyle,i.lineWidth]=[e.color,2],bo(i,e.path.map(r))}function lI(i,{title:e,words:t="",unit:n,series:s,path:r,power:o}){let a=document.createElement("strong"),l=o?`10${[...String(o)].map(d=>af[d]).join("")} `:"";a.textContent=n&&!r?`${W(e)} [${l}${W(n)}]`:W(e);let c=document.createElement("span");c.className="legend";for(let{name:d,color:f,dash:p=[]}of s?.length>1?s:[]){let[g,m]=[document.createElement("span"),document.createElement("i")];m.style.background=cI(f,p),g.append(m,W(d)),c.append(g)}let u=document.createElement("span");u.className="words",u.textContent=W(t),i.lastChild.replaceChildren(a,u,c);let h=r?W("with the point that moves"):s?W("over time"):"";i.firstChild.setAttribute("aria-label",`${[a.textContent,W(t),h].filter(Boolean).join(", ")}.`)}function cI(i,e){if(!e.length)return i;let t=0;return`repeating-linear-gradient(90deg, ${e.map((s,r)=>{let[o,a]=[t,t+=s];return`${r%2?"transparent":i} ${o}px ${a}px`}).join(", ")})`}function uI(i){let e=Math.max(...Kf(i.series).map(Math.abs)),t=i.unit==="\xB0"||!(e>0)||e>=.01&&e<1e4;return{...i,power:t?0:Math.floor(Math.log10(e))}}var qa=(i,e=6)=>String(Number(i.toPrecision(e))).replace("-","\u2212");function Kf(i){let[e,t]=[1/0,-1/0];for(let{values:s}of i)for(let r of s)e=Math.min(e,r),t=Math.max(t,r);let n=t-e>1e-9*Math.max(Math.abs(e),Math.abs(t))?.06*(t-e):.5*Math.abs(t)||1;return[e-n,t+n]}function Dy(i,e,t,n,s,r){let[o,a]=[s-yt.left-yt.right,r-yt.top-yt.bottom];return(l,c)=>[yt.left+(l-i)/(e-i||1)*o,yt.top+(n-c)/(n-t)*a]}function rh(i,e,t){let n=(e-i)/t,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].find(a=>a*s>=n)*s,o=[];for(let a=Math.ceil(i/r);a*r<=e;a++)o.push(a*r);return o}function bo(i,e){i.beginPath(),e.forEach(([t,n],s)=>s?i.lineTo(t,n):i.moveTo(t,n)),i.stroke()}var Xa=i=>document.getElementById(i),oh=class{constructor(e,t,n){this.presets=e,this.act=n,Xa("playground").hidden=!1,document.documentElement.dataset.playground="",this.buttons=e.map((s,r)=>{let o=document.createElement("button");return o.type="button",o.addEventListener("click",()=>t(this.choose(r))),o}),Xa("presets").replaceChildren(...this.buttons),this.write()}write(){this.buttons.forEach((t,n)=>t.textContent=W(this.presets[n].title));let e=this.buttons.findIndex(t=>t.getAttribute("aria-pressed")==="true");e>=0&&this.choose(e)}find(e){let t=this.presets.findIndex(({key:o})=>o===e),n=this.choose(Math.max(0,t)),[s,r]=[Xa("presets"),this.buttons[Math.max(0,t)]];return s.scrollLeft+=r.getBoundingClientRect().left-.5*(s.clientWidth-r.offsetWidth),e&&t<0&&this.tell(W("The playground has no motion called {named}; it has {keys}.",{named:String(e),keys:this.presets.map(({key:o})=>o).join(", ")})),n}tell(e){let t=document.createElement("li");t.textContent=e,Xa("story").prepend(t)}choose(e){return this.buttons.forEach((t,n)=>t.setAttribute("aria-pressed",String(n===e))),Xa("story").replaceChildren(...this.presets[e].story.map(t=>this.sentence(t))),this.presets[e]}sentence(e){let t=document.createElement("li"),n=W(e.say),[,s,r,o]=/^(.*?)\[(.+?)\](.*)$/s.exec(n)??[null,`${n} `,e.set&&W(e.label??"Show it"),""];if(t.append(s),!r)return t;let a=document.createElement("button");return Object.assign(a,{type:"button",textContent:r}),a.addEventListener("click",()=>this.act(e)),a.addEventListener("pointerup",()=>a.blur()),t.append(a,o),t}};var hI={momentum_norm:"|L|",momentum_space:"L in space","|L|\xB2":"|L|\xB2"},ah=class{constructor(e,t,n){this.list=e,this.take(t,n)}take(e,t,n=!1){this.data=t,this.rows={},this.list.replaceChildren();for(let[a,l]of[...e.energies?[["energy",t.energyName]]:[],...e.momenta?[["momentum","|L|"]]:[],...e.velocities?[["velocity","|\u03A9|"]]:[]])this.rows[a]=this.row(l);let s=Object.entries(t.drift);if(!s.length||n)return;let r=s.reduce((a,l)=>l[1]>a[1]?l:a),o=(hI[r[0]]??r[0]).replaceAll("_"," ");this.row("largest drift").textContent=`${et(r[1],2)} (${W(o)})`}row(e){let[t,n]=[document.createElement("dt"),document.createElement("dd")];t.textContent=W(e);let s=document.createElement("div");return s.append(t,n),this.list.append(s),n}show(e){let t=(r,o)=>{this.rows[r]&&this.rows[r].textContent!==o&&(this.rows[r].textContent=o)},{energy:n=[1,this.data.energyUnit],momentum:s=[1,"kg m\xB2/s"]}=this.data.units??{};e.energy!==null&&t("energy",`${et(e.energy/n[0])} ${n[1]}`),e.momentum&&t("momentum",`${et(e.momentum.length()/s[0])} ${s[1]}`),e.velocity&&t("velocity",`${et(e.velocity.length(),5)} rad/s`)}};var dI=[["video/webm;codecs=vp9","webm"],["video/webm;codecs=vp8","webm"],["video/webm","webm"],["video/mp4","mp4"]];var Uy=()=>typeof MediaRecorder<"u"&&typeof HTMLCanvasElement.prototype.captureStream=="function"&&!!Fy(),Fy=()=>dI.find(([i])=>MediaRecorder.isTypeSupported(i)),lh=class{constructor(e,t,n){let[s,r]=Fy();this.canvas=e,this.begun=performance.now();let o=[],a=e.captureStream(30);this.recorder=new MediaRecorder(a,{mimeType:s,videoBitsPerSecond:8e6}),this.recorder.addEventListener("dataavailable",({data:l})=>l.size&&o.push(l)),this.recorder.addEventListener("stop",()=>{for(let l of a.getTracks())l.stop();n(o.length?new Blob(o,{type:s}):null,r)}),this.recorder.start(),this.waiting=setTimeout(()=>this.close(),1e3*t)}get passed(){return(performance.now()-this.begun)/1e3}paint(e){this.draw=e,e(this.canvas)}close(){this.draw?.(this.canvas),this.waiting=setTimeout(()=>this.stop(),3e3/30)}stop(){clearTimeout(this.waiting),this.recorder.state!=="inactive"&&this.recorder.stop()}};var fI=760,[Jf,pI,Qf]=[.5,10,60],Hn=i=>document.getElementById(i),ch=class{constructor(e){this.page=e;let t=(n,s)=>Hn(n).addEventListener("click",s);t("link",()=>this.copyLink()),t("embed",()=>this.copyEmbedCode()),t("spec",()=>this.copySpec()),t("picture",()=>this.savePicture()),t("film",()=>this.film?this.film.stop():this.saveFilm()),Hn("film-length").addEventListener("change",()=>this.check())}take(){Hn("spec").hidden=!this.page.instrument?.kind.toml;for(let e of["copied","saved"])Hn(e).hidden=!0;this.say(""),this.given=null,this.suggest()}say(e,t){Hn("shared").textContent=W(e,t)}async copy(e,t){let n=Hn("copied");n.value=e,n.hidden=!1;try{await navigator.clipboard.writeText(e),this.say(t)}catch{this.say("This browser keeps the clipboard from pages in frames: copy the text from the field below."),n.select()}}copyLink(){let{whole:e,fragment:t}=this.page.address;return e===null?this.copy(`#${t}`,"A page in a notebook has no address of its own. Write it to a file with write_page, and add this to the file's address."):this.copy(e,e.startsWith("file:")?"The link is copied. It opens on this computer only: put the file on a web server to give it to others.":"The link is copied.")}copyEmbedCode(){let{whole:e}=this.page.address;if(e===null)return this.say("A page in a notebook has no address that another page could embed. Write it to a file with write_page, and put the file on a web server.");let t=`polhode: ${Hn("name").textContent}`,[n,s]=[e,t].map(o=>o.replaceAll("&","&amp;").replaceAll('"',"&quot;").replaceAll("<","&lt;")),r=`<iframe src="${n}" title="${s}" loading="lazy" sandbox="allow-scripts allow-downloads" allow="clipboard-write" style="width:100%; height:${fI}px; border:0"></iframe>`;return this.copy(r,"The code is copied: paste it into the HTML of a page.")}copySpec(){let e=this.page.instrument.toml(this.page.motion.span);return e===null?this.say("No spec says this start. A gyrostat needs its rotor's moment, and a free rotor a principal axis; a disk must begin in steady rolling."):this.copy(e,"The spec is copied: paste it into a file, and run polhode report on it.")}savePicture(){let e=this.page.shot();if(Oy()){let t=Hn("saved");return t.src=e.toDataURL("image/png"),t.hidden=!1,this.say("A frame like this one may not save files: save the picture below by a right click, or by a long press.")}return e.toBlob(t=>this.save(t,"png"),"image/png"),this.say("The picture is saved.")}saveFilm(){if(!Uy())return this.say("This browser cannot record films: it has no MediaRecorder for canvases. Firefox and Chromium have.");let e=this.check();if(e===null)return;let{timebar:t}=this.page,n=t.playing,s=()=>this.say("Recording: {passed} of {seconds} s.",{passed:Xt(Math.min(this.film.passed,e).toFixed(1)),seconds:et(e,3)}),r=setInterval(s,200);return this.film=new lh(this.page.shot(),e,(o,a)=>{clearInterval(r),this.film=null,Hn("film").textContent=W("Save film"),n||t.pause(),o&&this.save(o,a),this.say(o?Oy()?"The film is recorded. If it was not saved, this frame may not save files: open the page on its own.":"The film is saved.":"The browser has recorded nothing.")}),Hn("film").textContent=W("Stop"),n||t.toggle(),s()}frame(){this.film?.paint(e=>this.page.shot(e))}suggest(){if(this.given!==null)return;let{instrument:e,motion:t,timebar:n}=this.page,{period:s=null,nutationPeriod:r=null}=t?.solver??{},a=([s,r,e?.event??null].find(c=>c!==null&&Number.isFinite(c)&&c>0)??t?.span??0)/n.rate,l=a>0&&Number.isFinite(a)?Math.min(Qf,Math.max(Jf,a)):pI;Hn("film-length").value=Xt(String(Number(l.toFixed(1))))}check(){let e=Hn("film-length"),t=Number(e.value.trim().replace(",",".")),n=e.value.trim()!==""&&t>=Jf&&t<=Qf;e.setAttribute("aria-invalid",String(!n));let s=e.value.trim()||W("nothing");return this.say(n?"":"A film takes {least} to {most} s; got {got}. Type a number between these.",{least:Jf,most:Qf,got:s}),this.given=n?t:this.given,n?t:null}save(e,t){let n=document.createElement("a");n.href=URL.createObjectURL(e),n.download=`${Hn("name").textContent.replace(/[^\p{L}\p{N}]+/gu,"-").replace(/^-+|-+$/g,"")||"motion"}.${t}`,n.click(),setTimeout(()=>URL.revokeObjectURL(n.href),6e4)}};function Oy(){try{return window.self!==window.top&&!window.localStorage}catch{return!0}}var is={s:["sec","secs","second","seconds"],ms:["msec","millisecond","milliseconds"],us:["usec","\xB5s","\u03BCs","microsecond","microseconds"],ns:["nsec","nanosecond","nanoseconds"],min:["mins","minute","minutes"]},By={deg:["\xB0","degs","degree","degrees"],rad:["rads","radian","radians"]},ss={"deg/s":["\xB0/s","deg/sec","degree/s","degrees/s","degrees/sec","dps","deg s-1","deg s^-1","deg_s","deg_per_s","deg_per_sec"],"rad/s":["rad/sec","radian/s","radians/s","radians/sec","rad s-1","rad s^-1","rad_s","rad_per_s","rad_per_sec"],rpm:["rev/min","r/min"]},ep={"deg/s":Math.PI/180,"rad/s":1,rpm:Math.PI/30},mI={"m/s\xB2":1,"m/s^2":1,"m/s2":1,"m/s/s":1,g:9.80665},ky=/^(.*?)\s*[[(]([^\])]*)[\])]\s*$/;function uh(i,e){let t=i.trim().toLowerCase().split(/\s+/).join(" ");return Object.keys(e).find(n=>n===t||e[n].includes(t))??null}function gI(i){let e=ky.exec(i);return e?.[1]?e[1]:i.trim()}function dr(i,e){let t=ky.exec(i);if(t)return uh(t[2],e);let n=i.trim().toLowerCase().split("_");for(let s=Math.min(4,n.length-1);s>0;s--){let r=uh(n.slice(-s).join("_"),e);if(r)return r}return null}var mi=(i,e="xyz")=>[...e].map(t=>i.replace("{}",t)),xI=[{name:"AndroSensor",time:["time since start in ms"],timeUnit:"ms",gyro:mi("gyroscope {}"),rateUnit:"rad/s",acceleration:[mi("accelerometer {}")],perUnit:1},{name:"phyphox",time:["time"],timeUnit:"s",gyro:mi("gyroscope {}"),rateUnit:"rad/s",acceleration:[mi("acceleration {}"),mi("accelerometer {}")],perUnit:1},{name:"Sensor Logger",time:["seconds_elapsed"],timeUnit:"s",gyro:mi("{}"),rateUnit:"rad/s",acceleration:[mi("{}")],perUnit:1},{name:"Sensor Logger, all in one file",time:["seconds_elapsed"],timeUnit:"s",gyro:mi("gyroscope_{}"),rateUnit:"rad/s",acceleration:[mi("totalacceleration_{}")],perUnit:1},{name:"Betaflight",time:["time"],timeUnit:"us",gyro:mi("gyroadc[{}]","012"),rateUnit:"deg/s",acceleration:[mi("accsmooth[{}]","012")],perUnit:null}];function $a(i,e){let t=e.map(n=>i.flatMap((s,r)=>s.trim().toLowerCase()===n||gI(s).trim().toLowerCase()===n?[r]:[]));return t.every(n=>n.length===1)?t.map(([n])=>n):null}function tp(i,e){for(let t of e.time){let n=$a(i,[t]);if(n)return n[0]}return null}var zy=i=>xI.find(e=>$a(i,e.gyro)&&tp(i,e)!==null)??null;function Gy(i,e){let t=i.includes("(")?i.trim().slice(i.trim().lastIndexOf("(")+1).replace(/[) ]+$/,"").toLowerCase():"";return mI[t]??e.perUnit}var dt=class extends Error{},Ya=i=>`"${i.length>60?`${i.slice(0,57)}...`:i}"`;var _t=i=>Za(i,.5);function Za(i,e){let t=Float64Array.from(i).sort();if(!t.length)return NaN;let n=e*(t.length-1),s=Math.floor(n),r=Math.min(s+1,t.length-1);return t[s]+(n-s)*(t[r]-t[s])}function Fi(i){let e=Math.floor(i);return i-e!==.5?Math.round(i):e%2===0?e:e+1}var kt=i=>Float64Array.from({length:Math.max(i.length-1,0)},(e,t)=>i[t+1]-i[t]);function rs(i){let e=[];for(let t=0;t<i.length;t++){if(!i[t])continue;let n=t;for(;t<i.length&&i[t];)t+=1;e.push([n,t])}return e}function Wn(i,e,t=!1){let[n,s]=[0,i.length];for(;n<s;){let r=n+s>>1;i[r]<e||t&&i[r]===e?n=r+1:s=r}return n}function gi(i){return Float64Array.from({length:i.length/3},(e,t)=>Math.hypot(i[3*t],i[3*t+1],i[3*t+2]))}var fr=(i,e)=>Float64Array.from({length:i.length/3},(t,n)=>i[3*n+e]);function os(i,e=0,t=i.length/3){let n=[0,0,0];for(let s=e;s<t;s++)for(let r=0;r<3;r++)n[r]+=i[3*s+r];return n.map(s=>s/(t-e))}function hh(i,e=3){let t=[];for(let n of i)for(let s=0;s+3*e<n.length;s++)t.push(Math.abs(n[s+3*e]-3*n[s+2*e]+3*n[s+e]-n[s]));return t.length?_t(t)/(.6745*Math.sqrt(20)):0}var ip=[";","	",","," "],dh=60,Wy=2e3,Vy=1e6,yI=new Set(["","nan","na","n/a","null","none","-"]),qy=/^(?:[+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:e[+-]?\d+)?|[+-]?(?:nan|inf|infinity))$/i,_I=/^[+-]?[\d.]+(?:[eE][+-]?\d+)?\s+[+-]?[\d.]+(?:[eE][+-]?\d+)?$/,vI=/^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,6})?$/,Xy=/^[+-]?\d*,\d+(?:[eE][+-]?\d+)?$/,MI=/"[^"]*"|[^\s[("]+(?:[ \t]*(?:\[[^\]]*\]|\([^)]*\)))?/g;function $y(i){let e=i.replace(/^\uFEFF/,"").split(/\r\n|\n|\r/);return e.at(-1)===""&&e.pop(),e.map((t,n)=>{if(t.includes("\0")||t.includes("\uFFFD"))throw new dt(W("line {line} is not UTF-8 text, so this is not a table. Choose the app's CSV file, unpacked from its archive.",{line:n+1}));if(t.length>Vy)throw new dt(W("line {line} has more than {most} characters. Choose a table with one sample in each line.",{line:n+1,most:Vy}));return{number:n+1,text:t}})}var fh=i=>/^\s*(?:[#%]|$)/.test(i);function So(i,e){if(!i.includes('"')){let r=i.trim();return e===" "?r?r.split(/\s+/):[]:i.split(e).map(o=>o.trim())}let t=e===" "?i.trim().split(/\s+/).join(" "):i,n=[],s=0;for(;;){for(;t[s]===" "&&e!==" ";)s+=1;let r="";if(t[s]==='"'){for(s+=1;t[s]!=='"'||t[s+1]==='"';s++){if(s>=t.length)return null;t[s]==='"'&&(s+=1),r+=t[s]}if(s+=1,s<t.length&&t[s]!==e)return null}else{let o=t.indexOf(e,s);r=o<0?t.slice(s):t.slice(s,o),s=o<0?t.length:o}if(n.push(r.trim()),s>=t.length)return n;s+=1}}function sp(i){let e=i.slice(0,Wy+dh),t=e.filter(({text:d})=>!fh(d)).slice(0,dh),s=ip.map(d=>({delimiter:d,...bI(t,d)})).reduce((d,f)=>f.count>d.count?f:d);if(!s.count){let d=t.length?W("its first line is {text}",{text:Ya(t[0].text)}):W("it is empty");throw new dt(W("it has no line of numbers in two columns or more, between commas, semicolons, tabs or blanks; {first}. Choose a table with one sample in each line.",{first:d}))}let{delimiter:r,begin:o}=s,a=So(t[o].text,r),l=t[o].number,c=d=>({delimiter:r,width:a.length,names:d,first:l}),u=e.filter(({number:d,text:f})=>fh(f)&&f.trim()&&d<t[0].number).slice(-1);if(o>1){let d=wI(t[o-2].text,t[o-1].text,r,a);if(d.length)return c(d)}let h=o?[t[o-1]]:u;for(let{text:d}of h){let f=np(d,r,a);if(f.length)return c(f)}if(o){let{number:d,text:f}=h[0];throw new dt(W("line {line} must name the {columns} columns that line {first} has; got {names} names. Name each, or delete the line.",{line:d,columns:a.length,first:l,names:Zy(f,r).length}))}return c([])}function bI(i,e){let t=null,n=[];return i.forEach(({text:s},r)=>{let o=So(s,e)??[];t===null&&SI(o)&&(t=r),t!==null&&n.push(o.length)}),t===null?{count:0,begin:0}:{count:n.filter(s=>s===n[0]).length,begin:t}}function SI(i){let e=i.filter(Boolean),t=e.filter(n=>qy.test(n));return i.length>1&&2*t.length>e.length&&!e.some(n=>_I.test(n))}var Yy=i=>i.trimStart().replace(/^[#%]+/,""),Zy=(i,e)=>So(Yy(i),e)??[];function np(i,e,t){let n=Zy(i,e);return e===" "&&n.length!==t.length&&(n=(Yy(i).match(MI)??[]).map(r=>r.replace(/^"+|"+$/g,""))),n.length===t.length-1&&!t.at(-1)&&(n=[...n,""]),n.length===t.length&&n.some(Boolean)&&!n.some(r=>qy.test(r))?n:[]}var Hy=i=>[is,By,ss].some(e=>uh(i,e));function wI(i,e,t,n){let s=np(i,t,n),r=np(e,t,n).map(o=>o.replace(/^[[\]()]+|[[\]()]+$/g,""));return!s.length||!r.some(Hy)||s.some(Hy)?[]:s.map((o,a)=>r[a]?`${o} [${r[a]}]`:o)}function jy(i,e){if(e.delimiter===",")return"point";let n=i.slice(0,Wy+dh).filter(({number:s,text:r})=>s>=e.first&&!fh(r)).slice(0,dh).flatMap(({text:s})=>s.split(e.delimiter).map(r=>r.replace(/^[ "]+|[ "]+$/g,"")));return n.some(s=>Xy.test(s))&&!n.some(s=>s.includes("."))?"comma":"point"}function Ky(i,e,t,n){let s=t.map(()=>[]),r=[];for(let{number:o,text:a}of i){if(o<e.first||fh(a))continue;let l=So(a,e.delimiter);if(!l)throw new dt(W("line {line} has quotes that do not close. Check the line.",{line:o}));for(;l.length>e.width&&!l.at(-1);)l.pop();if(l.length!==e.width){let c=e.delimiter===","?"line {line} has {cells} cells, and line {first} has {width}. Check the line, or delete it. Is the comma a decimal one? Then save it with semicolons.":"line {line} has {cells} cells, and line {first} has {width}. Check the line, or delete it.";throw new dt(W(c,{line:o,cells:l.length,first:e.first,width:e.width}))}t.forEach((c,u)=>s[u].push(AI(l[c],n,()=>W("line {line}, {column}",{line:o,column:rp(e,c)})))),r.push(n==="comma"?l[t[0]].replaceAll(",","."):l[t[0]])}return{numbers:s.map(o=>Float64Array.from(o)),texts:r}}function AI(i,e,t){if(yI.has(i.toLowerCase()))return NaN;if(e==="comma"&&i.includes("."))throw new dt(W("{where}: {cell} has a point, and the other numbers have decimal commas. Choose one of them.",{where:t(),cell:Ya(i)}));let n=e==="comma"&&Xy.test(i)?i.replace(",","."):i,s=vI.test(n)?Number(n):NaN;if(Number.isFinite(s)&&!(s===0&&/^[+-]?[0.]*[1-9]/.test(n)))return s;let r=Number.isNaN(s)?"must be a number in decimal digits":s===0?"is so small that nothing is left of it":"is too large for a number",o=n.includes(":")?"Dates and times of day are not read: give times as plain numbers, like seconds from the start.":"Correct it, or leave the cell blank.";throw new dt(`${t()}: ${Ya(i)} ${W(r)}. ${W(o)}`)}var ph=i=>W("column {column}",{column:i+1}),rp=(i,e)=>i.names[e]?`${ph(e)} ${Ya(i.names[e])}`:ph(e);var Jy=8,EI=3,TI=.02,RI=1.1,Qy=1e12,op=1e-9,CI=1e-10,II={s:0,ms:3,us:6,ns:9},PI={s:1,ms:1e3,us:1e6,ns:1e9},i_=40;function s_(i){let e=$y(i);for(let t=0;t<Math.min(e.length,2e3);t++)for(let n of ip){let s=zy(So(e[t].text,n)??[]);if(!s)continue;let r=e.slice(t);if(!r.slice(1).some(o=>/[^ \t;,]/.test(o.text)))throw new dt(W("no sample stands below the header in line {line}. Log again.",{line:e[t].number}));return{form:sp(r),dialect:s,lines:e}}return{form:sp(e),dialect:null,lines:e}}function r_({form:i,dialect:e}){let{names:t}=i;if(e){let[a,l]=[tp(t,e),$a(t,e.gyro)],c=e_(l.map(u=>t[u]),ss);return{time:a,timeUnit:dr(t[a],is)??e.timeUnit,gyro:l,rateUnit:dr(t[l[0]],ss)?c:e.rateUnit}}let n=t.flatMap((a,l)=>dr(a,is)?[l]:[]),s=t.flatMap((a,l)=>dr(a,ss)?[l]:[]),r=n.length===1?n[0]:null,o=s.length===3?s:null;return{time:r,timeUnit:r===null?null:dr(t[r],is),gyro:o,rateUnit:o&&e_(o.map(a=>t[a]),ss)}}function e_(i,e){let t=new Set(i.map(n=>dr(n,e)).filter(Boolean));return t.size===1?[...t][0]:null}function o_({form:i,dialect:e,lines:t},n){if(n.time===null||!n.gyro||n.gyro.includes(null))throw new dt(W("it is not known which columns have the time and the angular velocities: no app that is known writes such a header. Choose them."));let s=[n.time,...n.gyro],r=s.find((p,g)=>s.indexOf(p)<g);if(r!==void 0)throw new dt(W("{column} is chosen twice. Choose another column for each.",{column:rp(i,r)}));if(!(n.rateUnit in ep))throw new dt(W("the unit of the angular velocity is not known: the file does not say it. Choose deg/s, rad/s or rpm."));if(!(n.timeUnit in is))throw new dt(W("the unit of the time is not known: the file does not say it. Choose it."));let o=[],a=e?LI(i,e,o):null,{numbers:l,texts:c}=Ky(t,i,[...s,...a?a.places:[]],jy(t,i)),u=NI(l[0],c,n.timeUnit),h=n_("rates",u,t_(l.slice(1,4),ep[n.rateUnit]));if(h.times.length<Jy)throw new dt(W("a gyro log must have {least} finite samples at different times; this one has {count}. Log for longer.",{least:Jy,count:h.times.length}));let d=a?n_("accelerations",u,t_(l.slice(4,7),a.unit)):null,f=!!d?.times.length;return{times:h.times,rates:h.values,accelerationTimes:f?d.times:null,acceleration:f?d.values:null,dialect:e?.name??null,rateUnit:n.rateUnit,notes:[...o,...h.notes]}}function LI(i,e,t){for(let n of e.acceleration){let s=n.join()===e.gyro.join()?null:$a(i.names,n);if(!s)continue;let r=Gy(i.names[s[0]],e);return r!==null?{places:s,unit:r}:(t.push(W("Accelerations are left out, as their unit is not known.")),null)}return null}function t_(i,e){let t=new Float64Array(3*i[0].length);return i.forEach((n,s)=>n.forEach((r,o)=>{t[3*o+s]=r*e})),t}function NI(i,e,t){let n=i.map(o=>t==="min"?60*o:o/PI[t]),s=n.reduce((o,a)=>Number.isFinite(a)?Math.max(o,Math.abs(a)):o,0);if(s===0||2**(Math.floor(Math.log2(s))-52)<=CI)return n;let r=null;return n.map((o,a)=>{if(!Number.isFinite(o))return NaN;let l=DI(e[a],II[t]??0)*(t==="min"?60n:1n);return r??=l,Number(l-r)/10**i_})}function DI(i,e){let[,t,n,s="",r="0"]=/^([+-]?)(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/.exec(i.trim()),o=i_-s.length+Number(r)-e,a=BigInt(n+s||"0"),l=o>=0?a*10n**BigInt(o):a/10n**BigInt(-o);return t==="-"?-l:l}function n_(i,e,t){let n=Array.from(e.keys()).filter(y=>Number.isFinite(e[y])&&[0,1,2].every(v=>Number.isFinite(t[3*y+v]))),s=[];n.length<e.length&&s.push(W("{count} lines without finite values are left out.",{count:e.length-n.length}));let r=y=>({t:Float64Array.from(y,v=>e[v]),x:Float64Array.from(y.flatMap(v=>[t[3*v],t[3*v+1],t[3*v+2]]))}),{t:o,x:a}=r(n);UI(i,o,a);let l=kt(o),c=l.filter(y=>y!==0).map(Math.abs),u=c.length?_t(c):op;if(u<op)throw new dt(W("times of {what} must lie {least} s apart or more; got {got} s. Check which column has the times, and their unit.",{what:W(i),least:op,got:u}));if(l.every(y=>y>0))return{times:o,values:a,notes:s};l.some(y=>y<0)&&s.push(W("Lines are not in the order of time; they were sorted.")),n=n.sort((y,v)=>e[y]-e[v]),{t:o,x:a}=r(n);let h=y=>y===0||o[y]>o[y-1],d=y=>h(y)||[0,1,2].some(v=>a[3*y+v]!==a[3*y-3+v]),f=Array.from(o.keys()),p=f.filter(y=>d(y)&&!h(y)).length,g=p>=Math.max(EI,TI*o.length),m=f.filter(g?d:h);m.length<o.length&&s.push(W("{count} samples come at a time that was there already; the first of each is kept.",{count:o.length-m.length})),g&&s.push(W("The clock is rounded: {count} samples come at a time that was there already, with other values; they are taken at equal steps.",{count:p}));let x=r(m.map(y=>n[y]));return{times:g?FI(x.t):x.t,values:x.x,notes:s}}function UI(i,e,t){for(let[n,s]of[["times",e],[i,t]]){let r=s.reduce((o,a)=>Math.max(o,Math.abs(a)),0);if(r>Qy)throw new dt(W("{what} must be at most {most} in SI units; got {got}. Check which columns they are, and their unit.",{what:W(n),most:Qy,got:r}))}}function FI(i){let e=Array.from(i.keys()).filter(h=>h===0||i[h]>i[h-1]),t=e.length>1?_t(kt(e.map(h=>i[h]))):0,n=Float64Array.from(i);e.forEach((h,d)=>{let f=e[d+1]??i.length,p=Math.min(f<i.length?i[f]-i[h]:t,t);for(let g=h;g<f;g++)n[g]=i[h]+(g-h)/(f-h)*p});let s=i.length,r=.5*(s-1),o=i.reduce((h,d)=>h+d,0)/s,a=i.reduce((h,d,f)=>h+(f-r)*(d-o),0)/(s*(s*s-1)/12),l=i.map((h,d)=>h-(o+a*(d-r))),[c,u]=l.reduce(([h,d],f)=>[Math.min(h,f),Math.max(d,f)],[1/0,-1/0]);return u-c<=RI*t?Float64Array.from({length:s},(h,d)=>i[0]+a*d):n}function wo(i){let e=i.length,t=i.map(r=>Float64Array.from(r)),n=i.map((r,o)=>Float64Array.from({length:e},(a,l)=>o===l?1:0));for(let r=0;r<60;r++){let o=!1;for(let a=0;a<e-1;a++)for(let l=a+1;l<e;l++){let c=t[a][l];if(Math.abs(c)<=1e-17*Math.sqrt(Math.abs(t[a][a]*t[l][l]))||Math.abs(c)<1e-300)continue;o=!0;let[u,h]=l_(t[a][a],c,t[l][l]);for(let d=0;d<e;d++)[t[d][a],t[d][l]]=[u*t[d][a]-h*t[d][l],h*t[d][a]+u*t[d][l]];for(let d=0;d<e;d++)[t[a][d],t[l][d]]=[u*t[a][d]-h*t[l][d],h*t[a][d]+u*t[l][d]];t[a][l]=t[l][a]=0;for(let d=0;d<e;d++)[n[d][a],n[d][l]]=[u*n[d][a]-h*n[d][l],h*n[d][a]+u*n[d][l]]}if(!o)break}let s=t.map((r,o)=>o).sort((r,o)=>t[r][r]-t[o][o]);return{values:s.map(r=>t[r][r]),vectors:s.map(r=>n.map(o=>o[r]))}}function l_(i,e,t){let n=(t-i)/(2*e),s=(n<0?-1:1)/(Math.abs(n)+Math.hypot(n,1)),r=1/Math.hypot(s,1);return[r,s*r]}function c_(i){let e=i.length,t=i.map((r,o)=>Float64Array.from({length:e},(a,l)=>o===l?1:0));for(let r=0;r<60;r++){let o=!1;for(let a=0;a<e-1;a++)for(let l=a+1;l<e;l++){let[c,u]=[i[a],i[l]],[h,d,f]=[xi(c,c),xi(c,u),xi(u,u)];if(Math.abs(d)<=1e-16*Math.sqrt(h*f)||d===0)continue;o=!0;let[p,g]=l_(h,d,f);a_(c,u,p,g),a_(t[a],t[l],p,g)}if(!o)break}let n=i.map(r=>Math.sqrt(xi(r,r))),s=n.map((r,o)=>o).sort((r,o)=>n[o]-n[r]);return{values:s.map(r=>n[r]),vectors:s.map(r=>Array.from(t[r]))}}function a_(i,e,t,n){for(let s=0;s<i.length;s++){let[r,o]=[i[s],e[s]];i[s]=t*r-n*o,e[s]=n*r+t*o}}function xi(i,e){let t=0;for(let n=0;n<i.length;n++)t+=i[n]*e[n];return t}function mh(i,e){let t=e.length,n=i.map((r,o)=>[...r,e[o]]);for(let r=0;r<t;r++){let o=r;for(let a=r+1;a<t;a++)Math.abs(n[a][r])>Math.abs(n[o][r])&&(o=a);if([n[r],n[o]]=[n[o],n[r]],n[r][r]===0||!Number.isFinite(n[r][r]))return null;for(let a=r+1;a<t;a++){let l=n[a][r]/n[r][r];for(let c=r;c<=t;c++)n[a][c]-=l*n[r][c]}}let s=new Array(t);for(let r=t-1;r>=0;r--){let o=n[r][t];for(let a=r+1;a<t;a++)o-=n[r][a]*s[a];s[r]=o/n[r][r]}return s}var Ws=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]],gh=([i,e,t])=>xi(i,Ws(e,t));var u_=Math.SQRT2,h_=[[0,1],[0,2],[1,2]],OI=.02,BI=.5,kI=2,[zI,GI]=[75,.6],VI=5,HI=Math.PI/180,WI=([i,e,t,n],[s,r,o,a])=>[i*s-e*r-t*o-n*a,i*r+e*s+t*a-n*o,i*o-e*a+t*s+n*r,i*a+e*o-t*r+n*s];function ap(i){let e=Math.hypot(...i),t=e<.001?.5-e*e/48:Math.sin(.5*e)/e;return[Math.cos(.5*e),...i.map(n=>t*n)]}function lp([i,e,t,n]){return[[1-2*(t*t+n*n),2*(e*t-i*n),2*(e*n+i*t)],[2*(e*t+i*n),1-2*(e*e+n*n),2*(t*n-i*e)],[2*(e*n-i*t),2*(t*n+i*e),1-2*(e*e+t*t)]]}function ja(i,e){let t=[[1,0,0,0]];for(let n=1;n<i.length;n++){let s=i[n]-i[n-1],[r,o]=[zt(e,n-1),zt(e,n)],a=Ws(r,o),l=WI(t[n-1],ap(r.map((u,h)=>.5*s*(u+o[h])+s*s/12*a[h]))),c=Math.hypot(...l);t.push(l.map(u=>u/c))}return t}var zt=(i,e)=>[i[3*e],i[3*e+1],i[3*e+2]];function Ka(i,e){let t=i.length,n=new Float64Array(18*t);for(let s=0;s<t;s++){let r=lp(i[s]),o=zt(e,s);for(let a=0;a<3;a++){let l=18*s+6*a;for(let c=0;c<3;c++)n[l+c]=r[a][c]*o[c];h_.forEach(([c,u],h)=>{n[l+3+h]=(r[a][c]*o[u]+r[a][u]*o[c])/u_})}}return n}function cp(i){let e=[0,1,2].map(t=>[0,1,2].map(n=>t===n?i[t]:0));return h_.forEach(([t,n],s)=>{e[t][n]=e[n][t]=i[3+s]/u_}),e}function qI(i){let e=i.reduce((f,p)=>f+p.elapsed.length,0),t=Array.from({length:6},()=>new Float64Array(3*e)),n=0;for(let{elapsed:f,rates:p}of i){let g=f.length,m=Ka(ja(f,p),p),x=xh(m,0,g);for(let y=0;y<g;y++)for(let v=0;v<3;v++,n++)for(let M=0;M<6;M++)t[M][n]=m[18*y+6*v+M]-x[6*v+M]}let{values:s,vectors:r}=c_(t),o=cp(r[5]),a=Math.sign(o[0][0]+o[1][1]+o[2][2])||1,l=wo(o.map(f=>f.map(p=>a*p))),[c,u]=l.vectors,h=[c,u,Ws(c,u)],d=[0,1,2].map(f=>h.map(p=>p[f]));return{moments:XI(l.values),axes:d,singularValues:s}}function xh(i,e,t){let n=new Float64Array(18);for(let s=e;s<t;s++)for(let r=0;r<18;r++)n[r]+=i[18*s+r];return n.map(s=>s/(t-e))}function XI(i){let e=.5*(i[0]+i[1]+i[2]),t=Math.max(e-i[0],1e-300),n=Math.max(e-i[1],.02*t),s=Math.max(e-i[2],OI*t),r=[n+s,t+s,t+n].sort((o,a)=>o-a);return r.map(o=>o/r[2])}function d_(i){let e=qI(i),t=hh(i.map(({rates:u})=>u)),n=i.reduce((u,{elapsed:h})=>u+h.length,0),s=6*t*Math.sqrt(n),r=i.map(({elapsed:u,rates:h})=>{let d=gi(h);return kt(u).map((f,p)=>f*d[p+1])}),o=Math.max(...r.map(u=>u.reduce((h,d)=>h+d,0))),a=Math.max(...r.map(_t)),l=Math.max(...i.map(({rates:u})=>_t(gi(u)))),c=null;return a>kI?c=W("The rates say that the body turns by {angle} rad from sample to sample, too far to be followed: the rates are of another unit, like deg/s, or the times are.",{angle:bt(a,3)}):l>zI&&e.moments[0]>GI?c=W("The rates, about {rates} rad/s, are beyond what gyros can tell, and make the body nearly a sphere. Both happen where rates in deg/s are read as rad/s: choose their unit.",{rates:bt(l,3)}):o<BI?c=W("The body turned by {angle} rad only: nothing can be said of its inertia.",{angle:bt(o,2)}):e.singularValues[4]<s&&(c=$I(i)),{...e,noise:t,degenerate:c}}function $I(i){let e=i.map(({rates:o})=>{let a=gi(o),l=a.length,c=[0,1,2].map(d=>a.reduce((f,p,g)=>f+o[3*g+d],0)/l),u=Math.hypot(...c);return{away:Math.max(...a.map((d,f)=>{let p=xi(zt(o,f),c)/Math.max(d*u,1e-300);return Math.acos(Math.min(1,Math.max(-1,p)))/HI})),speed:a.reduce((d,f)=>d+f,0)/l,toward:c.map(d=>d/Math.max(u,1e-300))}}),{away:t,speed:n,toward:s}=e.reduce((o,a)=>a.away>o.away?a:o),r=`(${Jr(s.map(o=>o.toFixed(2)))})`;return t<VI?W("The rates ({rates} rad/s) stay within {angle}\xB0 of one direction of the device, {axis}: the body spins about a principal axis, or is a sphere; either way the log does not determine the moments. Throw it with a tumble, best about its middle axis.",{rates:bt(n,3),angle:bt(t,2),axis:r}):W("Within the noise, bodies of quite different moments fit the rates ({rates} rad/s, up to {angle}\xB0 from {axis}). Throw it longer or faster, with a tumble about its middle axis.",{rates:bt(n,3),angle:t.toFixed(0),axis:r})}var f_=600,YI=2;function p_(i,e,t,n=0){let{throws:s,windows:r}=i,[o,a]=[JI(i.fit,s[n]),s[n]],{moments:l}=o,c=m_(o,a),[u,h]=os(c),d=o.starts[n].map((v,M)=>v*l[M]),[f,p]=[a.times[0],a.times.at(-1)],g=Float64Array.from({length:f_},(v,M)=>f+(p-f)*M/(f_-1)),m=i.misfit!==null,x=Jr([0,1].map(v=>`I${v+1}/I3 ${m?"\u2248":"="} ${up(l[v],3,m)}`)),y={type:"body",traced:1,shape:"box or ellipsoid of the same inertia",surface:null,ellipsoid:null,changed:!0,azimuth:Math.atan2(h,u)};return{name:t,key:null,summary:W("Free flight from {begin} s to {end} s of the log, and the exact motion of the fitted body: {ratios}.",{begin:bt(f,4),end:bt(p,4),ratios:x}),notes:["A gyro tells the moments up to a common factor: on this page the largest is 1 kg m\xB2.",...e.notes],panels:[y,{type:"sphere",title:"Momentum sphere",legend:"other polhodes",words:"L in body axes runs along its polhode; dots are the log's samples",measured:c},{type:"poinsot"}],drift:{},scatters:[],plots:[],times:QI(g),joined:!0,space:null,up:"L",free:l,energyName:"energy",energyUnit:"J",model:{solver:"FreeMotion",moments:l,momentum:d,attitude:[1,0,0,0],epoch:a.epoch},story:ZI(i,e,r[n],x)}}function ZI({throws:i,windows:e,limit:t,start:n,rest:s,fit:r,misfit:o},a,l,c){let u=a.dialect?W("Read as a log of {app}, rates in {unit}.",{app:a.dialect,unit:a.rateUnit}):W("Rates are read in {unit}, as chosen.",{unit:a.rateUnit}),h=bt(l.end-l.start,2),d=e.length>1?W("{count} free flights are found; this one lasts {duration} s: {reason}.",{count:e.length,duration:h,reason:W(l.reason)}):W("One free flight is found; it lasts {duration} s: {reason}.",{duration:h,reason:W(l.reason)}),f=o!==null,p=Jr(r.bias.map(x=>up(x,3,f))),g=s?"{ratios}; the gyro's bias is {bias} rad/s, which a rest confirms.":"{ratios}; the gyro's bias is {bias} rad/s, and no rest in the log confirms it.",m=r.drag?"The residuals, {rms} rad/s rms, are those of the noise, {noise} rad/s: within it the log is the motion of a rigid body with drag.":"The residuals, {rms} rad/s rms, are those of the noise, {noise} rad/s: within it the log is the motion of a free rigid body.";return[`${u} ${d}`,W(g,{ratios:c,bias:p}),...r.drag?[jI(r.drag,f)]:[],o??W(m,{rms:bt(r.rms,2),noise:bt(n.noise,2)}),...t===null?[]:[KI(t,i)]]}function up(i,e,t){return(t?bt(i,YI):i.toFixed(e)).replace("-","\u2212")}function jI(i,e){let t=Jr(i.map(s=>up(s,4,e))),n=W("The curves are of the free motion that touches it in the middle of the flight.");return`${W("Drag slows it: c/I3 = {numbers} of the torque \u2212c |\u03C9| \u03C9 along the axes.",{numbers:t})} ${n}`}function KI(i,e){let t=e.reduce((n,{times:s})=>n+s.length,0);return W("Samples at the gyro's limit, {limit} deg/s, are left out; {count} remain.",{limit:bt(i*180/Math.PI,4),count:t})}function JI(i,e){let t=os(m_(i,e)),n=[t[0]<0?-1:1,1,t[2]<0?-1:1];n[1]=n[0]*n[2];let s=r=>r.map((o,a)=>n[a]*o);return{...i,axes:i.axes.map(s),starts:i.starts.map(s)}}function m_({moments:i,axes:e,bias:t},{rates:n,times:s}){return Array.from(s,(r,o)=>{let a=zt(n,o).map((u,h)=>u-t[h]),l=i.map((u,h)=>u*(e[0][h]*a[0]+e[1][h]*a[1]+e[2][h]*a[2])),c=Math.hypot(...l)||1;return l.map(u=>u/c)}).flat()}function QI(i){let e="";for(let t of new Uint8Array(i.buffer))e+=String.fromCharCode(t);return{kind:"f8",shape:[i.length],data:btoa(e)}}var eP=[.3,.6,1.2,2.4],tP=2,nP=1,_h=.03,yh=[.3,1],iP=3,sP=.07,rP=4,hp=12,g_=6,x_=2e4,oP=.1;function y_(i,e,t){let n=[];for(let[s,r]of cP(i,gi(e)))for(let o=s;o<=r;o+=x_/2){let a=Math.min(o+x_,r+1);if(i[a-1]-i[o]>=t&&n.push(...uP(i.slice(o,a),e.slice(3*o,3*a),t,o)),a>r)break}return xP(n)}function __(i,e){let t=Ka(ja(i,e),e),n=Math.floor(i.length/4),[s,r]=[n,i.length-n],o=R_(i,t,s,r,A_(t,s,r).inertia);return!o||o.first>s||o.last<r-1?null:{...o,change:T_(t,o.first,o.last+1,o.inertia)}}function v_(i,e,t){let n=t.map(({first:l,last:c,change:u})=>{let h=e.slice(3*l,3*c+3),d=Ka(ja(i.slice(l,c+1),h),h);return{...M_(d,0,c+1-l),change:u}}),s=t.map((l,c)=>c).sort((l,c)=>t[c].turn-t[l].turn),r=[];for(let l of s){let c=r.find(u=>aP([...u,l].map(h=>n[h])));c?c.push(l):r.push([l])}let[o,a]=[[],-1/0];for(let l of r){let c=l.reduce((u,h)=>u+t[h].turn,0);c>a&&([o,a]=[l,c])}return[t.filter((l,c)=>o.includes(c)),t.filter((l,c)=>!o.includes(c))]}function M_(i,e,t){let n=xh(i,e,t),s=new Float64Array(36);for(let r=e;r<t;r++)b_(s,i,r);return{mean:n,spread:S_(n,s.map(r=>r/(t-e)))}}function b_(i,e,t){for(let n=0;n<3;n++){let s=18*t+6*n;for(let r=0;r<6;r++)for(let o=0;o<6;o++)i[6*r+o]+=e[s+r]*e[s+o]}}function S_(i,e){return[0,1,2,3,4,5].map(t=>[0,1,2,3,4,5].map(n=>e[6*t+n]-i[t]*i[n]-i[6+t]*i[6+n]-i[12+t]*i[12+n]))}var Ao=(i,e,t)=>{let n=0;for(let s=0;s<6;s++)n+=i[e+s]*t[s];return n},w_=(i,e)=>Math.hypot(Ao(i,0,e),Ao(i,6,e),Ao(i,12,e));function aP(i){let e=i.map(({spread:s})=>Math.max(s.reduce((r,o,a)=>r+o[a],0),1e-300)),t=i[0].spread.map((s,r)=>s.map((o,a)=>i.reduce((l,c,u)=>l+c.spread[r][a]/e[u],0))),n=wo(t).vectors[0];return i.every(({mean:s,spread:r,change:o})=>{let a=r.reduce((l,c,u)=>l+n[u]*c.reduce((h,d,f)=>h+d*n[f],0),0);return Math.sqrt(Math.max(a,0))/Math.max(w_(s,n),1e-12)<Math.max(_h,3*o)})}var A_=(i,e,t)=>E_(M_(i,e,t));function E_({mean:i,spread:e}){let{values:t,vectors:n}=wo(e),s=null;for(let r=0;r<hp;r++){let[o,a]=[Math.cos(Math.PI/hp*r),Math.sin(Math.PI/hp*r)],l=n[0].map((d,f)=>o*d+a*n[1][f]),c=o*o*t[0]+a*a*t[1],u=lP(l),h=u?Math.sqrt(Math.max(c,0))/Math.max(w_(i,l),1e-12):1/0;if((!s||h<s.change)&&(s={inertia:l,change:h}),r===0&&u)break}return s}function lP(i){let e=cp(i),t=Math.sign(e[0][0]+e[1][1]+e[2][2]),{values:n}=wo(e.map(s=>s.map(r=>t*r)));return n[0]>.03*n[2]&&n[0]+n[1]>.8*n[2]}function T_(i,e,t,n){let s=xh(i,e,t),r=[0,6,12].map(a=>Ao(s,a,n)),o=0;for(let a=e;a<t;a++)for(let l=0;l<3;l++)o+=(Ao(i,18*a+6*l,n)-r[l])**2;return Math.sqrt(o/(t-e))/Math.max(Math.hypot(...r),1e-12)}function cP(i,e){let t=i.length,n=Array.from(e,c=>c>nP),s=n.map((c,u)=>n.slice(Math.max(u-2,0),u+3).some(Boolean)),r=n.map((c,u)=>c||u>=2&&u+2<t&&s.slice(u-2,u+3).every(Boolean)),o=kt(i),a=Math.max(oP,5*_t(o)),l=[];for(let c=0;c<t;c++)r[c]&&(c>0&&r[c-1]&&o[c-1]<a?l.at(-1)[1]=c:l.push([c,c]));return l}function uP(i,e,t,n){let s=Ka(ja(i,e),e),r=gi(e),o=new Float64Array(i.length);for(let c=1;c<i.length;c++)o[c]=o[c-1]+.5*(r[c]+r[c-1])*(i[c]-i[c-1]);let a=new Uint8Array(i.length),l=[];for(let{begin:c,end:u,inertia:h}of hP(i,s,o)){let d=0;for(let m=c;m<u;m++)d+=a[m];if(d/(u-c)>.5)continue;let f=R_(i,s,c,u,h);if(!f||i[f.last]-i[f.first]<t)continue;let{first:p,last:g}=f;a.fill(1,p,g+1),l.push({first:p+n,last:g+n,change:T_(s,p,g+1,f.inertia),turn:o[g]-o[p]})}return l}function hP(i,e,t){let n=[],s=i.length,r=_t(kt(i)),o=dP(e);for(let a of new Set(eP.map(l=>Math.max(6,Fi(l/r))))){let l=a>s&&!n.length&&s>=6?s:a,c=[];for(let h=0;h<=s-l;h+=Math.max(1,Math.floor(l/g_)))t[h+l-1]-t[h]>=tP&&c.push(h);let u=c.map(h=>E_(fP(o,h,l)));for(let h of pP(c.length,Math.max(1,Math.floor(c.length/g_)))){let d=h[0];for(let f of h)u[f].change<u[d].change&&(d=f);d!==void 0&&u[d].change<_h&&n.push({begin:c[d],end:c[d]+l,...u[d]})}}return n.sort((a,l)=>a.change-l.change)}function dP(i){let e=i.length/18,[t,n]=[new Float64Array(18*(e+1)),new Float64Array(36*(e+1))];for(let s=0;s<e;s++){for(let o=0;o<18;o++)t[18*(s+1)+o]=t[18*s+o]+i[18*s+o];let r=new Float64Array(36);b_(r,i,s);for(let o=0;o<36;o++)n[36*(s+1)+o]=n[36*s+o]+r[o]}return{total:t,squares:n}}function fP({total:i,squares:e},t,n){let s=t+n,r=Float64Array.from({length:18},(a,l)=>(i[18*s+l]-i[18*t+l])/n),o=Float64Array.from({length:36},(a,l)=>(e[36*s+l]-e[36*t+l])/n);return{mean:r,spread:S_(r,o)}}function pP(i,e){let[t,n]=[Math.floor(i/e),i%e],s=0;return Array.from({length:e},(r,o)=>Array.from({length:t+(o<n?1:0)},()=>s++))}function R_(i,e,t,n,s){let[r,o]=[t,n-1],a=s;for(let l=0;l<rP;l++){let c=Float64Array.from({length:3*i.length},(g,m)=>Ao(e,6*m,a)),u=gP(i,c,r,o),h=mP(rs(u.slice(r,o+1)));if(!h)return null;let[d,f]=[r+h[0],r+h[1]-1];for(;d>0&&u[d-1];)d-=1;for(;f<i.length-1&&u[f+1];)f+=1;if(f-d<6)return null;let p=A_(e,d,f+1);if(a=p.inertia,!Number.isFinite(p.change))return null;if(d===r&&f===o)break;[r,o]=[d,f]}return{first:r,last:o,inertia:a}}function mP(i){let e=null;for(let t of i)(!e||t[1]-t[0]>e[1]-e[0])&&(e=t);return e}function gP(i,e,t,n){let s=i.length,r=gi(e).map(g=>Math.max(g,1e-12)),o=(g,m)=>Math.hypot(e[3*m]-e[3*g],e[3*m+1]-e[3*g+1],e[3*m+2]-e[3*g+2]),a=_t(Float64Array.from({length:n-t},(g,m)=>o(t+m,t+m+1)/r[t+m])),l=_t(kt(i)),c=Math.min(Math.max(1,Fi(sP/l)),Math.max(1,Math.ceil(4*a/(yh[0]*l)))),u=Float64Array.from({length:Math.max(s-c,0)},(g,m)=>o(m,m+c)/(i[m+c]-i[m])/Math.min(r[m+c],r[m])),h=_t(u.slice(t,Math.max(n-c+1,t+1))),d=Math.min(Math.max(yh[0],iP*h),yh[1]),f=Array.from(u,g=>g<d);for(let[g,m]of rs(f.map(x=>!x))){let x=Math.min(m+c-1,s-1);x-g<=2*c+2&&o(g,x)/r[g]<yh[0]*(i[x]-i[g])+2*a&&f.fill(!0,g,m)}let p=new Array(s).fill(!1);return f.forEach((g,m)=>{g&&p.fill(!0,m,m+c+1)}),p}function xP(i){let e=[];for(let t of[...i].sort((n,s)=>n.first-n.last-(s.first-s.last)))e.every(n=>t.last<n.first||t.first>n.last)&&e.push(t);return e.sort((t,n)=>t.first-n.first)}var Mh=.3,vh=.1,yP=.015,_P=.35,vP=.6,MP=1,bP=.03,C_=[8.8,10.8],SP=.3;function dp({times:i,rates:e,accelerationTimes:t,acceleration:n}){let{means:s,size:r}=N_(i,e),o=yP+.5*AP(e),a=D_(s,r,o),l=kt(i);if(i.forEach((d,f)=>{((l[f-1]??0)>=Mh||(l[f]??0)>=Mh)&&(a[f]=!1)}),n){let d=EP(t,n,i);a.forEach((f,p)=>{a[p]=f&&d[p]})}let c=gi(s).map(d=>d<_P),u=I_(P_(a.map((d,f)=>d&&!!c[f]),i),i,e);if(u.length)return u;let h=d=>[0,1,2].every(f=>Math.abs(s[3*d+f])<vP);return u=I_(P_(a.map((d,f)=>d&&h(f)),i),i,e),n||wP(u,e)?u:[]}function L_(i){let e=dp(i),t=[0,0,0],n=0;for(let[s,r]of e){let o=os(i.rates,s,r+1),a=r+1-s;for(let l=0;l<3;l++)t[l]+=o[l]*a;n+=a}return n?t.map(s=>s/n):t}function I_(i,e,t){if(!i.length)return[];let n=i.map(([r,o])=>os(t,r,o+1)),s=0;return i.forEach(([r,o],a)=>{e[o]-e[r]>e[i[s][1]]-e[i[s][0]]&&(s=a)}),i.filter((r,o)=>Math.hypot(...n[o].map((a,l)=>a-n[s][l]))<bP)}function wP(i,e){if(i.length<2)return!1;let t=os(e,i[0][0],i[0][1]+1);return i.slice(1).some(([n],s)=>{for(let r=i[s][1];r<n;r++)if(Math.hypot(...t.map((o,a)=>e[3*r+a]-o))>MP)return!0;return!1})}function N_(i,e){let t=_t(kt(i)),n=Math.max(1,Fi(vh/t)),s=i.length,r=Math.floor(n/2),o=new Float64Array(e.length);for(let a=0;a<3;a++)for(let l=0;l<s;l++){let c=0;for(let u=l-r;u<l-r+n;u++)c+=e[3*Math.min(Math.max(u,0),s-1)+a];o[3*l+a]=c/n}return{means:o,size:Math.max(2,Fi(Mh/t))}}function AP(i){let e=[...new Set(Array.from(i.slice(0,6e4),t=>Fi(t*1e9)/1e9))].sort((t,n)=>t-n);return e.length>1?_t(kt(e)):0}function D_(i,e,t){let n=i.length/3,s=Math.floor(e/2),r=new Array(n).fill(!0);for(let a=0;a<3;a++){let l=fr(i,a);for(let c=0;c<n;c++){if(!r[c])continue;if(c<s||c>=n-Math.floor((e-1)/2)){r[c]=!1;continue}let[u,h]=[1/0,-1/0];for(let d=c-s;d<c-s+e;d++)u=Math.min(u,l[d]),h=Math.max(h,l[d]);r[c]=h-u<t}}let o=new Array(n).fill(!1);for(let a=0;a<n;a++)if(r[a])for(let l=a-s;l<a-s+e;l++)o[l]=!0;return o}function EP(i,e,t){if(i.length<2)return Array.from(t,()=>!1);let{means:n,size:s}=N_(i,e),r=gi(n),o=D_(n,s,SP).map((a,l)=>a&&r[l]>C_[0]&&r[l]<C_[1]);return Array.from(t,a=>{if(a<i[0]||a>i.at(-1))return!1;let l=Math.min(Math.max(Wn(i,a,!0)-1,0),i.length-2),c=(a-i[l])/(i[l+1]-i[l]);return(1-c)*Number(o[l])+c*Number(o[l+1])>.5})}function P_(i,e){let t=[];for(let[n,s]of rs(i)){let r=n===0?0:Wn(e,e[n]+vh/2),o=s===e.length?s-1:Wn(e,e[s-1]-vh/2,!0)-1;o>r&&e[o]-e[r]>=Mh-vh&&t.push([r,o])}return t}var U_=.3,TP=.05,RP=.35,F_=3,[CP,IP]=[1,4],PP=.02;function O_(i,e){let[t,n]=[i.accelerationTimes,i.acceleration],s=t.length>1?_t(kt(t)):U_,r=Math.max(3,Fi(U_/s));if(t.length<r)return[];let o=NP(i),a=FP(i,o,r);if(!a)return[];let l=Float64Array.from(t,(h,d)=>Math.hypot(...o[d].map((f,p)=>n[3*d+p]-f[0]*a[0]-f[1]*a[1]-f[2]*a[2]))),c=Array.from(t,(h,d)=>l[d]<F_&&h>=i.times[0]&&h<=i.times.at(-1)),u=[];for(let[h,d]of LP(rs(c),Math.max(2,Fi(PP/s)))){let f=Math.max(CP,IP*_t(l.slice(h,d))),[p,g]=[h,d-1];for(;l[p]>=f;)p+=1;for(;l[g]>=f;)g-=1;t[g]-t[p]>=e&&u.push({first:p,last:g})}return u}function LP(i,e){let t=[];for(let[n,s]of i)t.length&&n-t.at(-1)[1]<=e?t.at(-1)[1]=s:t.push([n,s]);return t}function NP(i){let e=DP(i.times,i.rates);return Array.from(i.accelerationTimes,t=>{let[n,s]=[i.rates,e].map(o=>UP(i.times,o,t)),r=[[1,0,0],[0,1,0],[0,0,1]].map(o=>{let[a,l]=[Ws(n,Ws(n,o)),Ws(s,o)];return a.map((c,u)=>c+l[u])});return[0,1,2].map(o=>r.map(a=>a[o]))})}function DP(i,e){let t=new Float64Array(e.length),n=i.length-1;for(let s=0;s<=n;s++)for(let r=0;r<3;r++){let o=c=>e[3*c+r];if(s===0||s===n){let c=s===0?0:n-1;t[3*s+r]=(o(c+1)-o(c))/(i[c+1]-i[c]);continue}let[a,l]=[i[s]-i[s-1],i[s+1]-i[s]];t[3*s+r]=(a*a*o(s+1)+(l*l-a*a)*o(s)-l*l*o(s-1))/(a*l*(a+l))}return t}function UP(i,e,t){if(t<=i[0])return zt(e,0);if(t>=i.at(-1))return zt(e,i.length-1);let n=Wn(i,t,!0)-1,s=(t-i[n])/(i[n+1]-i[n]),r=zt(e,n+1);return zt(e,n).map((o,a)=>o+s*(r[a]-o))}function FP(i,e,t){let[n,s]=[i.accelerationTimes,i.acceleration],r=[];for(let l=0;l+t<=n.length;l+=Math.max(1,Math.floor(t/8))){if(n[l]<i.times[0]||n[l+t-1]>i.times.at(-1))continue;let c=[0,1,2].map(p=>[0,1,2].map(g=>p===g?.001/TP**2:0)),u=[0,0,0],h=0;for(let p=l;p<l+t;p++){let g=zt(s,p);for(let m=0;m<3;m++){h+=g[m]*g[m]/t;for(let x=0;x<3;x++){u[x]+=e[p][m][x]*g[m]/t;for(let y=0;y<3;y++)c[x][y]+=e[p][m][x]*e[p][m][y]/t}}}let d=mh(c,u),f=d&&h-d.reduce((p,g,m)=>p+g*u[m],0);d&&f<F_**2&&Math.hypot(...d)<RP&&r.push({tells:gh(c),left:f,at:d})}if(!r.length)return null;let o=Math.max(...r.map(({tells:l})=>l));return r.filter(({tells:l})=>l>=.1*o).reduce((l,c)=>c.left<l.left?c:l).at}var fp=8,pp=.25,k_=.15,[OP,BP]=[.004,.1],B_=.1,mp=1-1e-6;function z_(i,e=null){let t=L_(i),{t:n,rates:s}=kP(i.times,i.rates.map((a,l)=>a-t[l%3])),r=i.acceleration?GP(i,n,s):zP(n,s),o=Array.from(i.times).filter((a,l)=>e===null||[0,1,2].every(c=>Math.abs(i.rates[3*l+c])<e*mp));return r.filter(({start:a,end:l})=>Wn(o,l,!0)-Wn(o,a)>=fp)}function kP(i,e){let t=_t(kt(i)),n=Float64Array.from(i,(c,u)=>Math.max(...[0,1,2].map(h=>Math.abs(e[3*u+h])))),s=Za(n,.999),r=t>0?Math.trunc(Math.min(OP,BP/Math.max(s,1e-9))/t):1,o=Math.floor(i.length/r);if(r<2||o<2*fp)return{t:i,rates:e};let a=c=>Float64Array.from({length:o},(u,h)=>{let d=0;for(let f=h*r;f<(h+1)*r;f++)d+=c[f];return d/r}),l=[0,1,2].map(c=>a(fr(e,c)));return{t:a(i),rates:Float64Array.from({length:3*o},(c,u)=>l[u%3][Math.floor(u/3)])}}function zP(i,e){let t=y_(i,e,k_).filter(({first:s,last:r})=>i[r]-i[s]>=pp),[n]=v_(i,e,t);return n.map(({first:s,last:r})=>({start:i[s],end:i[r],reason:"keeps an angular momentum"}))}function GP(i,e,t){let n=i.accelerationTimes;return O_(i,k_).map(({first:s,last:r})=>({start:n[s],end:n[r],reason:"the accelerometer feels no weight"})).filter(({start:s,end:r})=>r-s>=pp).map(s=>VP(e,t,s))}function VP(i,e,t){let[n,s]=[Wn(i,t.start),Wn(i,t.end,!0)];if(s-n<fp)return t;let r=__(i.slice(n,s),e.slice(3*n,3*s));if(!r||r.change>_h)return t;let[o,a]=[i[n+r.first],i[n+r.last]];return o-t.start>B_||t.end-a>B_||a-o<pp?t:{...t,start:r.first===0?t.start:o,end:r.last===s-n-1?t.end:a}}var bh=3,gp=.03,HP=-.1,WP=.003,[qP,XP]=[6,25],G_=1e-6,xp=.02,$P=.04,YP=1e-6;function yp(i,e,t,n=!1){let[s,r]=i.moments,o=t??{value:[0,0,0],spread:[gp,gp,gp]},a={shape:[r-s,.5*(s+r-1)],axes:i.axes,bias:[...o.value],drag:n?[0,0,0]:null,starts:e.map(({rates:l,zero:c})=>jP(i.axes,zt(l,c).map((u,h)=>u-o.value[h])))};for(let l of[100,500,2500,1/0])l<1/0&&!e.some(({elapsed:c})=>c.length>2*l)||(a=QP(a,e.map(c=>ZP(c,l)),o));return iL(a,Eo(a,e))}function ZP({elapsed:i,rates:e,zero:t},n){if(!Number.isFinite(n))return{elapsed:i,rates:e,zero:t};let s=Math.max(t-n/2,0),r=Math.min(t+n/2,i.length);return{elapsed:i.slice(s,r),rates:e.slice(3*s,3*r),zero:t-s}}var jP=(i,e)=>[0,1,2].map(t=>i[0][t]*e[0]+i[1][t]*e[1]+i[2][t]*e[2]),H_=([i,e])=>[.5*(1-i)+e,.5*(1+i)+e,1];function Eo({shape:i,axes:e,bias:t,drag:n,starts:s},r){let o=H_(i);return Math.min(...o)>WP?r.map(({elapsed:a,rates:l},c)=>{let u=n?null:new pi({moments:o,momentum:o.map((f,p)=>f*s[c][p])}),h=n&&KP(o,n,s[c],a),d=new Float64Array(l.length);return a.forEach((f,p)=>{let g=h?h[p]:u.angularVelocity(f);for(let m=0;m<3;m++)d[3*p+m]=l[3*p+m]-t[m]-xi(e[m],g)}),d}):null}function KP(i,e,t,n){let[s,r,o]=i,a=([h,d,f])=>{let p=Math.hypot(h,d,f);return[((r-o)*d*f-e[0]*p*h)/s,((o-s)*f*h-e[1]*p*d)/r,((s-r)*h*d-e[2]*p*f)/o]},l=new Array(n.length),c=Wn(n,0),u=(h,d,f)=>{let[p,g]=[t,0];for(let m=h;m!==d;m+=f){let x=Math.max(1,Math.ceil(Math.hypot(...p)*Math.abs(n[m]-g)/$P)),y=(n[m]-g)/x;for(let v=0;v<x;v++)p=JP(a,p,y);[l[m],g]=[p,n[m]]}};return u(c,n.length,1),u(c-1,-1,-1),l}function JP(i,e,t){let n=(l,c)=>e.map((u,h)=>u+c*t*l[h]),s=i(e),r=i(n(s,.5)),o=i(n(r,.5)),a=i(n(o,1));return e.map((l,c)=>l+t/6*(s[c]+2*r[c]+2*o[c]+a[c]))}function W_(i,e){let t=lp(ap(e.slice(2,5))),n=s=>[0,1,2].map(r=>t[r][s]);return{shape:[Math.min(Math.max(i.shape[0]+e[0],-1),1),Math.min(Math.max(i.shape[1]+e[1],HP),2)],axes:i.axes.map(s=>[0,1,2].map(r=>xi(s,n(r)))),bias:i.bias.map((s,r)=>s+e[5+r]),starts:i.starts.map((s,r)=>s.map((o,a)=>o+e[8+3*r+a])),drag:i.drag&&i.drag.map((s,r)=>s+e[8+3*i.starts.length+r])}}function QP(i,e,t){let n=i,s=Eo(n,e);if(!s)return n;let r=_t(s.flatMap(o=>Array.from(o,Math.abs)))*1.5+1e-9;for(let o=0;o<qP;o++){n=tL(n,e,t,r);let a=r;if(r=eL(Eo(n,e),q_(n)),Math.abs(r/a-1)<.02)break}return n}var q_=({starts:i,drag:e})=>8+3*i.length+(e?3:0);function eL(i,e){let t=i.flatMap(r=>Array.from({length:r.length/3},(o,a)=>xi(zt(r,a),zt(r,a)))),n=16*(_t(t)/2.366+1e-300),s=t.reduce((r,o)=>r+Math.min(o,n),0);return Math.max(Math.sqrt(s/Math.max(3*t.length-e,1)),1e-12)}function tL(i,e,t,n){let[s,r,o]=[i,Eo(i,e),.001];for(let a=0;a<XP;a++){let{normal:l,right:c}=nL(s,e,r,t,n),u=V_(r,s,t,n),h=null;for(;!h&&o<1e12;){let d=mh(l.map((m,x)=>m.map((y,v)=>v===x?y*(1+o)+1e-300:y)),c),f=d&&W_(s,d),p=f&&Eo(f,e),g=p?V_(p,f,t,n):1/0;g<u?h={tried:f,residuals:p,next:g}:o*=10}if(!h||([s,r]=[h.tried,h.residuals],o=Math.max(o/10,1e-12),u-h.next<YP*u))break}return s}function V_(i,{bias:e,drag:t},n,s){let r=e.reduce((o,a,l)=>o+((a-n.value[l])/n.spread[l])**2,0);for(let o of t??[])r+=(o/xp)**2;for(let o of i)for(let a of o){let l=Math.abs(a/s);r+=l<=bh?l*l:bh*(2*l-bh)}return r}function nL(i,e,t,n,s){let r=q_(i),o=Array.from({length:r},(c,u)=>{let h=u<5||u>=8+3*e.length?G_:G_*Math.max(1,...i.starts.flat().map(Math.abs)),[d,f]=[h,-h].map(p=>Eo(W_(i,Array.from({length:r},(g,m)=>m===u?p:0)),e));return!d||!f?t.map(p=>new Float64Array(p.length)):d.map((p,g)=>p.map((m,x)=>(f[g][x]-m)/(2*h)))}),a=Array.from({length:r},()=>new Array(r).fill(0)),l=new Array(r).fill(0);t.forEach((c,u)=>c.forEach((h,d)=>{let f=Math.min(1,bh*s/Math.max(Math.abs(h),1e-300))/s**2;for(let p=0;p<r;p++){let g=f*o[p][u][d];l[p]+=g*h;for(let m=0;m<=p;m++)a[p][m]+=g*o[m][u][d]}}));for(let c=0;c<r;c++)for(let u=0;u<c;u++)a[u][c]=a[c][u];for(let c=0;c<3;c++)a[5+c][5+c]+=n.spread[c]**-2,l[5+c]+=(n.value[c]-i.bias[c])/n.spread[c]**2;return(i.drag??[]).forEach((c,u)=>{let h=8+3*e.length+u;a[h][h]+=xp**-2,l[h]-=c/xp**2}),{normal:a,right:l}}function iL({shape:i,axes:e,bias:t,drag:n,starts:s},r){let o=H_(i),a=[0,1,2].sort((d,f)=>o[d]-o[f]),l=e.map(d=>a.map(f=>d[f])),c=gh(l)<0?-1:1,u=o[a[2]],h=(r??[]).flatMap(d=>[...d]);return{moments:a.map(d=>o[d]/u),axes:l.map(([d,f,p])=>[d,f,c*p]),bias:t,drag:n&&a.map(d=>n[d]/u),starts:s.map(d=>a.map((f,p)=>(p===2?c:1)*d[f])),residuals:r??[],rms:Math.sqrt(h.reduce((d,f)=>d+f*f,0)/Math.max(h.length,1))}}var Sh=3,sL=[125,245,250,500,1e3,2e3,4e3,143.4,286.7,573.4,1146.9,2293.8,4587.5].map(i=>i*Math.PI/180),rL=.0012,oL=.03,aL=1.5,lL=3,cL=3,X_=6,$_=1e-6,[uL,hL]=[20,32],dL=.8;function Y_(i){let e=[];for(let a=0;a<i.length;a+=3)(a===0||[0,1,2].some(l=>i[a+l]!==i[a-3+l]))&&e.push(i[a],i[a+1],i[a+2]);let t=Float64Array.from(e);if(t.length/3<2*Sh)return null;let n=Math.max(...[0,1,2].map(a=>Z_(fr(t,a).map(Math.abs)))),s=fL(t).filter(({level:a})=>a>(1-oL)*n),r=a=>s.some(({axis:l,side:c})=>l!==a.axis||c!==a.side),o=s.filter(a=>j_(a.level)||a.runs>1||r(a)).map(({edge:a})=>a);return o.length?Math.min(...o):null}var Z_=i=>Float64Array.from(i).sort().at(-Sh),j_=i=>sL.some(e=>Math.abs(i/e-1)<rL);function fL(i){let e=[0,1,2].map(r=>fr(i,r)),t=e.map(r=>{let o=kt(Array.from(new Set(r)).sort((a,l)=>a-l));return{step:o.length?Za(o,.05):0,noise:hh([r],1)}}),n=t.map(({step:r})=>r).filter(r=>r>0),s=[];return e.forEach((r,o)=>{let a=r.reduce((u,h)=>Math.max(u,Math.abs(h)),0),l=Math.max(n.length?Math.min(...n):0,$_*a),{noise:c}=t[o];for(let u of[1,-1]){let h=r.map(f=>u*f),d=Z_(h);for(let[f,p]of[[d,l],[d-.5*X_*c,X_*c]]){let g=p>0&&f>uL*p?pL(h,f,p):0;if(g){s.push({edge:p===l?d:f-p/2,level:f,axis:o,side:u,runs:g});break}}}}),s}function pL(i,e,t){let n=i.map(g=>(e-g)/t),s=Array.from(n,g=>Math.abs(g)<.5+1e-6),r=s.filter(Boolean).length,o=g=>n.reduce((m,x,y)=>m+ +(x<g&&!s[y]&&x>0),0),[a,l]=[o(4.5),o(16.5)];if(r<Sh||a>(aL-1)*r)return 0;let c=rs(Array.from(n,g=>g<16.5)).filter(([g,m])=>s.slice(g,m).filter(Boolean).length>=Sh).length,u=i.filter((g,m)=>s[m]),[h,d]=u.reduce(([g,m],x)=>[Math.min(g,x),Math.max(m,x)],[1/0,-1/0]);if(j_(e)&&d-h<=$_*e)return Math.max(c,1);let f=l<lL*a&&l>cL*2*Math.max(c,1);return n.reduce((g,m)=>Math.max(g,m),-1/0)<hL||r>dL*i.length||f?0:c}var K_=8,mL=1.4,gL=2,xL=.3,yL=.2,_L=.9,vL=.003;function ML(i){let e=Y_(i.rates),t=z_(i,e);if(!t.length)throw new dt(W("no free flight was found in the log: no stretch of a quarter of a second keeps an angular momentum, or feels no weight. Throw it with a spin of a turn a second or more, and log from before the throw until after the catch."));return{limit:e,windows:t,throws:t.map(n=>bL(i,n,e))}}function bL({times:i,rates:e},{start:t,end:n},s){let r=Array.from(i.keys()).filter(l=>i[l]>=t&&i[l]<=n&&(s===null||zt(e,l).every(c=>Math.abs(c)<s*mp)));if(r.length<K_)throw new dt(W("a throw must have {least} samples that are not at the gyro's limit; got {count}. Throw more slowly.",{least:K_,count:r.length}));let o=Math.floor(r.length/2),a=i[r[o]];return{times:Float64Array.from(r,l=>i[l]),elapsed:Float64Array.from(r,l=>i[l]-a),rates:Float64Array.from(r.flatMap(l=>zt(e,l))),zero:o,epoch:a}}function SL(i,e){let t=dp(i).map(([a,l])=>({start:i.times[a],end:i.times[l],mean:os(i.rates,a,l+1)})).filter(a=>!e.some(({start:l,end:c})=>a.start<c&&a.end>l)),n=t.reduce((a,{start:l,end:c})=>a+c-l,0);if(!(n>0))return null;let s=a=>[0,1,2].map(l=>t.reduce((c,u)=>c+(u.end-u.start)/n*a(u,l),0)),r=s((a,l)=>a.mean[l]),o=s((a,l)=>(a.mean[l]-r[l])**2);return{value:r,spread:o.map(a=>Math.hypot(vL,Math.sqrt(a)))}}function Q_(i){let{limit:e,windows:t,throws:n}=ML(i),s=d_(n);if(s.degenerate)throw new dt(s.degenerate);let r=SL(i,t),o=yp(s,n,r),a=J_(o,s.noise)&&yp(s,n,r,!0),l=a&&a.rms<_L*o.rms?a:o,c=n.flatMap(({rates:h})=>Array.from(h,d=>d*d)),u=Math.sqrt(c.reduce((h,d)=>h+d,0)/c.length);if(!(l.rms<yL*u))throw new dt(W("no free motion of a rigid body explains the log: the residuals, {residuals} rad/s, are not small beside the rates, {rates} rad/s. Check columns and units, or log a free flight.",{residuals:bt(l.rms,2),rates:bt(u,2)}));return{throws:n,windows:t,limit:e,start:s,rest:r,fit:l,misfit:J_(l,s.noise)}}function J_({residuals:i,rms:e,drag:t},n){let s=i.flatMap(f=>Array.from(f,Math.abs)),[r,o]=[_t(s)/.6745,s.reduce((f,p)=>f+p*p,0)],l=i.reduce((f,p)=>f+p.slice(3).reduce((g,m,x)=>g+m*p[x],0),0)/Math.max(o,1e-300),c=f=>f<100?bt(f,2):f.toFixed(0),u=null;if(r>mL*n?u=W("{times} times the noise of a sample",{times:c(r/n)}):l>xL?u=W("alike from sample to sample (correlation {correlation})",{correlation:Xt(l.toFixed(2))}):e>gL*n&&(u=W("larger than the noise at a few samples, up to {most} rad/s",{most:bt(Math.max(...s),2)})),!u)return null;let h={rms:bt(e,2),noise:bt(n,2),why:u};return`${W(t?"The log is not the motion of a rigid body with drag within its noise: the residuals ({rms} rad/s rms, noise {noise} rad/s) are {why}.":"The log is not a free rigid body's motion within its noise: the residuals ({rms} rad/s rms, noise {noise} rad/s) are {why}.",h)} ${W("A gyro's gains, a clock that jitters or a catch within the window do that; polhode fit fits gains too, and gives errors.")}`}var ev=64e6,wL="or drop it on this page: phyphox, Sensor Logger, AndroSensor, Betaflight, or any table with a time and three angular velocities. It stays on this computer.",An=(i,e={},...t)=>{let n=Object.assign(document.createElement(i),e);return n.append(...t),n},wh=class{constructor(e,t){this.open=t,this.input=An("input",{type:"file",accept:".csv,.txt,.tsv,text/csv,text/plain",hidden:!0}),this.input.addEventListener("change",()=>{this.input.files.length&&this.take(this.input.files[0]),this.input.value=""}),this.button=An("button",{type:"button",className:"wide"}),this.button.addEventListener("click",()=>this.input.click()),this.said=An("p",{id:"log-said"}),this.said.setAttribute("role","status"),this.form=An("form",{id:"log-columns",hidden:!0}),this.form.addEventListener("submit",n=>{n.preventDefault(),this.fit()}),this.hint=An("span",{className:"hint"}),this.root=An("section",{id:"log"},An("p",{},this.button," ",this.hint),this.input,this.said,this.form),e.after(this.root),this.listen(),this.write()}write(){this.button.textContent=W("Open a gyro log\u2026"),this.hint.textContent=W(wL),this.root.setAttribute("aria-label",W("A log of your own")),this.form.hidden||this.ask(),this.found&&!document.querySelector("#presets [aria-pressed=true]")&&this.fit()}listen(){let e=n=>[...n.dataTransfer?.types??[]].includes("Files"),t=n=>document.documentElement.classList.toggle("dropping",n);window.addEventListener("dragover",n=>{e(n)&&(n.preventDefault(),t(!0))}),window.addEventListener("dragleave",n=>!n.relatedTarget&&t(!1)),window.addEventListener("drop",n=>{e(n)&&(n.preventDefault(),t(!1),n.dataTransfer.files.length&&this.take(n.dataTransfer.files[0]))})}async take(e){this.form.hidden=!0,this.name=e.name;try{if(e.size>ev)throw new dt(W("it has {size} MB, and at most {most} MB are read. Cut the log to the throw.",{size:Math.round(e.size/1e6),most:ev/1e6}));let t=await e.text();if(t.startsWith("PK"))throw new dt(W("it is a zip archive. Unpack it, and choose the table inside, like Gyroscope.csv or Raw Data.csv."));this.table=s_(t),this.mapping=r_(this.table),this.ask();let{time:n,timeUnit:s,gyro:r,rateUnit:o}=this.mapping;n!==null&&s&&r&&o?await this.fit():this.say(W("no app that is known writes such a header. Choose what the columns are, and the units that the file does not say."))}catch(t){this.refuse(t)}}ask(){let{form:e,dialect:t}=this.table,{time:n,timeUnit:s,gyro:r,rateUnit:o}=this.mapping,a=Array.from({length:e.width},(h,d)=>[d,e.names[d]||ph(d)]),l=h=>Object.keys(h).map(d=>[d,d]);this.fields={time:pr("time",a,n),timeUnit:pr("unit of the time",l(is),s),x:pr("angular velocity x",a,r?.[0]),y:pr("angular velocity y",a,r?.[1]),z:pr("angular velocity z",a,r?.[2]),rateUnit:pr("its unit",l(ss),o)};let c=An("summary",{textContent:W("Columns and units")}),u=An("details",{open:!t},c,...Object.values(this.fields),An("button",{type:"submit",className:"wide",textContent:W("Read the log")}));this.form.replaceChildren(u),this.form.hidden=!1}async fit(){let e=Object.fromEntries(Object.entries(this.fields).map(([s,r])=>[s,r.querySelector("select").value])),t=s=>e[s]===""?null:Number(e[s]),n={time:t("time"),timeUnit:e.timeUnit,gyro:["x","y","z"].map(t),rateUnit:e.rateUnit};this.mapping=n,this.say(W("fitting\u2026")),await new Promise(s=>setTimeout(s,30));try{this.log=o_(this.table,n),this.found=Q_(this.log),this.show(AL(this.found.windows))}catch(s){this.refuse(s)}}show(e){let t=p_(this.found,this.log,this.name,e);this.open(t);for(let o of document.querySelectorAll("#presets button"))o.setAttribute("aria-pressed","false");document.getElementById("story").replaceChildren(...t.story.map(o=>An("li",{textContent:o}))),this.say("");let{windows:n}=this.found;if(n.length<2)return;let s=n.map(({start:o,end:a},l)=>[l,W("{least} to {most}",{least:`${bt(o,4)} s`,most:`${bt(a,4)} s`})]),r=pr("which throw",s,e);r.querySelector("select").addEventListener("change",o=>this.show(Number(o.target.value))),this.said.replaceChildren(r)}refuse(e){if(!(e instanceof dt||e instanceof RangeError))throw e;this.say(e.message,!0)}say(e,t=!1){this.said.textContent=e&&`${this.name}: ${e}`,this.said.classList.toggle("wrong",t)}};function AL(i){let e=0;return i.forEach(({start:t,end:n},s)=>{n-t>i[e].end-i[e].start&&(e=s)}),e}function pr(i,e,t){let n=An("select",{required:!0}),s=t!=null;return s||n.append(An("option",{value:"",textContent:W("choose\u2026")})),n.append(...e.map(([r,o])=>An("option",{value:String(r),textContent:o,selected:s&&r===t}))),An("label",{},`${W(i)} `,n)}var Ja=Math.SQRT2,[EL,TL]=[.5,8],RL=1.5,tv=[.5,1.6],_p=20,[nv,CL]=[8,240],[IL,PL]=[1,3600],iv=20,Ah=class{constructor(e,{seek:t,beyond:n,told:s}){this.root=e,this.seek=t,this.beyond=n,this.told=s,this.position=0,this.playing=!1,this.looping=!1,this.goesOn=!1,this.slider=e.querySelector("#seek"),this.play=e.querySelector("#play"),this.loop=e.querySelector("#loop"),this.speed=e.querySelector("#speed"),this.shown=e.querySelector("#now");let r=(o,a)=>e.querySelector(o).addEventListener("click",a);r("#play",()=>this.toggle()),r("#back",()=>this.step(-1)),r("#forth",()=>this.step(1)),r("#loop",()=>this.repeat()),r("#slower",()=>this.scale(1/Ja)),r("#faster",()=>this.scale(Ja)),this.slider.addEventListener("input",()=>{this.pause(),this.go(Number(this.slider.value))}),document.addEventListener("keydown",o=>this.key(o))}take(e,t,n=null,s=null){this.motion=e,this.slider.max=String(e.count-1),this.single=e.count<2||!(e.span>0);for(let r of this.root.querySelectorAll("button, input"))r.disabled=this.single;this.loop.hidden=!!e.endless,t&&(this.rate=LL(e,s),this.pause()),n===null?this.go(0):this.goTo(n)}key(e){if(this.single||e.ctrlKey||e.metaKey||e.altKey||e.target!==this.slider&&e.target.closest?.("input, select, textarea"))return;let t=e.target===this.slider,n=e.target.closest?.("button, a, summary");if(e.target.closest?.("canvas")&&e.key.startsWith("Arrow"))return;let r={" ":()=>!n&&this.toggle(),k:()=>this.toggle(),l:()=>this.repeat(),ArrowLeft:()=>!t&&this.step(e.shiftKey?-iv:-1),ArrowRight:()=>!t&&this.step(e.shiftKey?iv:1),Home:()=>!t&&this.home(),End:()=>!t&&this.to(this.motion.count-1),"+":()=>this.scale(Ja),"=":()=>this.scale(Ja),"-":()=>this.scale(1/Ja)}[e.key];r&&r()!==!1&&e.preventDefault()}toggle(){if(this.playing)return this.pause();this.position>=this.motion.count-1&&!this.motion.endless&&!this.goesOn&&this.go(0),this.playing=!0,this.begun=null,this.say(),requestAnimationFrame(e=>this.tick(e))}pause(){this.playing=!1,this.say()}repeat(){this.looping=!this.looping,this.say()}home(){if(!this.motion.endless)return this.to(0);this.pause(),this.beyond(this.motion.solver.epoch)}tick(e){if(!this.playing)return;let t=this.begun===null?0:Math.min((e-this.begun)/1e3,.25);this.begun=e,this.advance(this.time+t*this.rate),this.playing&&requestAnimationFrame(n=>this.tick(n))}advance(e){let t=this.motion.times[this.motion.count-1];if(e<=t)return this.goTo(e);if(this.motion.endless||this.goesOn&&!this.looping)return this.beyond(e);if(this.looping)return this.goTo(this.motion.times[0]+(e-t)%this.motion.span);this.goTo(t),this.pause()}step(e){this.to(Math.round(this.position)+e)}to(e){this.pause(),this.go(e)}go(e){this.position=Math.min(this.motion.count-1,Math.max(0,e)),this.time=this.motion.at(this.position).time,this.refresh()}goTo(e){this.time=e,this.position=this.motion.positionOf(e),this.refresh()}refresh(){this.slider.value=String(Math.round(this.position)),this.slider.style.setProperty("--part",`${100*this.position/Math.max(1,this.motion.count-1)}%`);let e=wn(this.time,Math.max(this.motion.span,Math.abs(this.time)));this.slider.setAttribute("aria-valuetext",e),this.shown.textContent=e,this.seek(this.position,this.time)}scale(e){let{span:t}=this.motion;this.rate=Math.min(t/IL,Math.max(t/PL,this.rate*e)),this.say()}quicken(e){e!==null&&e>_p*this.rate&&(this.rate=sv(e/_p)),this.say()}say(){this.play.setAttribute("aria-label",W(this.playing?"Pause":"Play")),this.play.dataset.playing=String(this.playing),this.loop.setAttribute("aria-pressed",String(this.looping)),this.rate&&(this.speed.textContent=Math.abs(this.rate-1)<.05?W("real time"):`\xD7${et(this.rate,2)}`),this.told()}};function LL(i,e){if(!(i.span>0))return 1;let t=i.hasUp?TL:EL,n=i.fastest?2*Math.PI*t/i.fastest:i.span/40,s=i.solver?.nutationPeriod,r=s&&Number.isFinite(s)?s/RL:1/0,o=Math.min(i.span/nv,Math.max(i.span/CL,Math.min(n,r))),a=Math.min(i.span/nv,(e??0)/_p);if(o>tv[0]&&o<tv[1]&&a<=1)return 1;if(a>o)return sv(a);let l=10**Math.floor(Math.log10(o));return([5,2,1].find(u=>u*l<=o*1.0001)??1)*l}function sv(i){let e=10**Math.floor(Math.log10(i));return[1,2,5,10].find(t=>t*e>=.9999*i)*e}var wp={};cs(wp,{BufferGeometry:()=>xt,Color:()=>Fe,ConeGeometry:()=>xs,CylinderGeometry:()=>ci,DataTexture:()=>li,Float32BufferAttribute:()=>tt,Group:()=>ut,InstancedMesh:()=>Yo,LinearFilter:()=>Ft,Matrix4:()=>Qe,Mesh:()=>$e,MeshBasicMaterial:()=>dn,MeshLambertMaterial:()=>_n,PlaneGeometry:()=>Qs,Quaternion:()=>ot,SphereGeometry:()=>On,Vector3:()=>C,circle:()=>Ui,contactSound:()=>av,decimal:()=>Xt,dot:()=>zs,drawUpTo:()=>ns,endsLegend:()=>bp,floor:()=>vo,globe:()=>_o,line:()=>jt,mapGlobe:()=>ov,mappedGlobe:()=>Mp,newPanel:()=>Vn,pairThrough:()=>La,path:()=>ts,pieces:()=>yo,polhodeThrough:()=>or,say:()=>W,specks:()=>ur,unpacked:()=>ht});var vp=[[33,102,172],[178,24,43]],rv=247,NL=6;function DL(){let i=new Uint8Array(1024);for(let e=0;e<256;e++){let t=e<127.5?0:1,n=Math.abs(e-127.5)/127.5;for(let s=0;s<3;s++)i[4*e+s]=Math.round(rv+(vp[t][s]-rv)*n**.8);i[4*e+3]=255}return i}function UL(i,e,t){let n=e*t,s=(a,l,c)=>Array.from({length:a},(u,h)=>{let d=(h+.5)/t-.5,f=Math.floor(d),p=g=>c?(g+l)%l:Math.min(Math.max(g,0),l-1);return[p(f),p(f+1),d-f]}),r=s(n,e,!0),o=s(i*t,i,!1);return(a,l,c)=>{o.forEach(([u,h,d],f)=>{let p=l+u*e,g=l+h*e;for(let m=0;m<n;m++){let[x,y,v]=r[m],M=a[p+x]+v*(a[p+y]-a[p+x]),w=a[g+x]+v*(a[g+y]-a[g+x]);c[f*n+m]=M+d*(w-M)}})}}function Mp(i,e){let t=i*e,n=DL(),s=new Uint8Array(4*t),r=new li(s,e,i);r.magFilter=r.minFilter=Ft,r.colorSpace="srgb";let o=new On(1,96,64);return o.rotateX(Math.PI/2),o.rotateZ(Math.PI),{mesh:new $e(o,new dn({map:r})),paint:(c,u=null)=>{for(let h=0;h<t;h++){let d=Math.round(c[h]);if(s.set(n.subarray(4*d,4*d+4),4*h),u?.(h))for(let f=0;f<3;f++)s[4*h+f]*=.35}r.needsUpdate=!0},pixels:s}}var bp=i=>[{color:`rgb(${vp[1].join(", ")})`,text:i[1]},{color:`rgb(${vp[0].join(", ")})`,text:i[0]}];function ov(i,e,{title:t,words:n,legend:s}){let r=i.lines?NL:1,[o,a]=[i.rows*r,i.columns*r],l=ht(i.levels),c=i.lines?ht(i.lines):null,u=ht(i.frames),[h,d]=[i.rows*i.columns,o*a],f=UL(i.rows,i.columns,r),{mesh:p,paint:g,pixels:m}=Mp(o,a),[x,y,v]=[new Float32Array(d),new Float32Array(d),new Uint8Array(d)],M=Vn(e,{title:t,words:n,radius:1.3});M.scene.add(p);for(let b of[-.5,0,.5])M.scene.add(Ui(1.002*Math.sqrt(1-b*b),1.002*b,e.family));M.legend=bp(s);let w=(b,I,T,L)=>{if(f(b,h*I,x),L!==0){f(b,h*T,y);for(let D=0;D<d;D++)x[D]+=L*(y[D]-x[D])}},A=b=>{let I=b%a===a-1?b+1-a:b+1,T=b+a<d?b+a:b;return v[b]!==v[I]||v[b]!==v[T]},_=-1;return M.update=b=>{if(b.position===_)return;_=b.position;let I=0;for(;I<u.length-2&&u[I+1]<=b.position;)I++;let T=Math.min(I+1,u.length-1),L=T>I?Math.min(1,(b.position-u[I])/(u[T]-u[I])):0;if(c){w(c,I,T,L);for(let D=0;D<d;D++)v[D]=Math.floor(x[D]/256*i.bands)}w(l,I,T,L),g(x,c&&A)},M.probe=()=>({shown:_,pixels:[...m.subarray(0,16)]}),M}var Sp=class{constructor(){this.on=!1,this.context=null,this.rate=0}toggle(){this.on=!this.on,this.on&&!this.context&&this.make(),this.on?this.context.resume():this.quiet()}make(){this.context=new AudioContext;let e=Float32Array.from({length:49},(t,n)=>n?1:0);this.oscillator=this.context.createOscillator(),this.oscillator.setPeriodicWave(this.context.createPeriodicWave(e,new Float32Array(49))),this.gain=this.context.createGain(),this.gain.gain.value=0,this.oscillator.connect(this.gain).connect(this.context.destination),this.oscillator.start()}follow(e){if(this.rate=e,!this.on)return;let{currentTime:t}=this.context;this.oscillator.frequency.setTargetAtTime(Math.min(e,2e3),t,.03),this.gain.gain.setTargetAtTime(e>0?.25:0,t,.03),clearTimeout(this.waiting),this.waiting=setTimeout(()=>this.quiet(),150)}quiet(){this.gain?.gain.setTargetAtTime(0,this.context.currentTime,.03)}probe(){return{on:this.on,rate:this.rate,frequency:this.oscillator?.frequency.value??null,gain:this.gain?.gain.value??null}}},av=new Sp;var FL={axis:hy,body:wy,poinsot:Ay,sphere:Iy,...globalThis.polhodePanels},Kt=i=>document.getElementById(i),Ap=class{constructor(e,t){this.language=t,t.changed=()=>this.retell(),this.view=new lu(()=>this.draw()),this.stage=new nh(this.view),this.panels=[],this.outgoing=[],this.canvases=[],this.waiting=null;let n=window.matchMedia("(prefers-color-scheme: dark)");this.theme=n.matches?Hs.dark:Hs.light,n.addEventListener("change",r=>this.dress(r.matches?Hs.dark:Hs.light)),Kt("theme").addEventListener("click",()=>this.dress(this.theme===Hs.dark?Hs.light:Hs.dark)),Kt("reset").addEventListener("click",()=>this.instrument?.reset());for(let r of document.querySelectorAll("button"))r.addEventListener("pointerup",()=>r.blur());new ResizeObserver(()=>this.sizes()!==this.shapes&&this.draw()).observe(Kt("panels")),this.room=new ju(["summary","refused","facts","notes","readouts","plots"].map(Kt)),this.plots=new sh(Kt("plots"),r=>{this.timebar.pause(),this.goTo(r)}),this.timebar=new Ah(Kt("timebar"),{seek:(r,o)=>this.show(r,o),beyond:r=>this.goTo(r),told:()=>this.told()}),this.address=new il(()=>this.seen,r=>this.follow(r,e)),this.views=new Zu(Kt("panels"),()=>this.looked()),this.sharing=new ch(this),this.playground=e.presets?new oh(e.presets,r=>this.open(r),r=>this.tell(r)):null,e.presets&&(this.reader=new wh(Kt("share"),r=>this.open(r)));let s=this.address.read();this.open(this.playground?.find(s.tables.preset)??e,s)}follow(e,t){let{tables:n}=e;n.lang!==(this.language.asked??void 0)&&(this.language.take(n.lang),this.playground?.write(),this.reader?.write()),this.open(this.playground?.find(n.preset)??t,e)}open(e,t=null){let n=this.timebar.playing;this.data=e,Kd(e),this.room.release(),this.view.letGo(),this.view.elevation=e.panels[0].elevation??this.view.elevation,this.view.azimuth=e.panels[0].azimuth??this.view.azimuth,this.instrument=null,Kt("refused").textContent="",this.shaped=!1,Kt("instrument").hidden=!e.model,Kt("facts").replaceChildren(),e.model&&(this.instrument=new $u(e.model,s=>this.reset(s)),this.epoch=this.instrument.setting.epoch),this.motion=e.model&&!e.attitude?this.instrument.motion(OL(e),e.space):new Gu(e),Kt("panels").replaceChildren(),this.canvases=e.panels.map(s=>qg(s,this.view)),this.canvases.forEach((s,r)=>this.listen(s,r)),this.views.take(e.panels.map(({type:s})=>s)),this.readouts=new ah(Kt("readouts"),this.motion,e),this.now=this.motion.at(0),this.build(),this.timebar.goesOn=!!this.instrument,this.timebar.take(this.motion,!0,null,this.instrument?.event),this.sharing.take(),t&&this.restore(t),n&&this.timebar.toggle(),this.address.write()}retell(){let{position:e,time:t}=this.now,n={...this.seen,t:e||t!==this.begins?t:null};this.playground?.write(),this.reader?.write(),this.open(this.data,{tables:n,refused:[]})}restore({tables:{t:e=null,preset:t,view:n=null,lang:s,...r},refused:o}){let[a,l]=[Kt("refused"),[...o]],c=()=>{a.textContent&&l.push({message:a.textContent}),a.textContent=""},u=Object.keys(r);u.length&&!this.instrument?l.push(new RangeError(`This motion has nothing to set; got ${Tn(u.join(", "))} in the link. Leave that out.`)):u.length&&this.instrument.set(r),c(),t!==void 0&&!this.playground&&l.push(new RangeError(`This page shows one motion; got preset=${Tn(t)} in the link. Leave that out.`)),s!==void 0&&!rr().includes(s)&&l.push(new RangeError(`lang must be ${rr().join(" or ")}; got ${Tn(s)}. Name one of these.`)),n!==null&&!this.views.enlarge(String(n))&&l.push(new RangeError(`view must be ${this.views.types.join(" or ")}; got ${Tn(n)}. Name one of these.`)),e!==null&&typeof e!="number"?l.push(new RangeError(`t must be a time in seconds; got ${Tn(e)}. Write it as a number, as in t=4.`)):e!==null&&this.goTo(e),c(),a.textContent=l.map(({message:h})=>h).join(" ")}get seen(){let{key:e}=this.data,{named:t}=this.views,n=!this.timebar.playing&&this.now.time!==this.begins;return{...this.language.asked?{lang:this.language.asked}:{},...e?{preset:e}:{},...this.instrument?.tables,...t?{view:t}:{},...n?{t:this.now.time}:{}}}get begins(){return this.instrument?.setting.epoch??this.motion.times[0]}tell({set:e,view:t}){return t?this.views.enlarge(t):(e&&this.instrument?.set(e)?this.timebar.quicken(this.instrument.event):e||this.instrument?.reset(),this.goTo(this.begins),!lv()&&!this.timebar.playing&&this.timebar.toggle(),this.address.write())}looked(){this.view.letGo(),this.draw(),this.address.write()}told(){this.sharing&&this.motion&&this.sharing.suggest(),this.instrument!==void 0&&this.address.changed()}reset(e){this.room.keep();let{epoch:t}=this.instrument.setting,n=t===this.epoch?this.now.time:t;this.epoch=t,this.shaped=e,Kt("summary").textContent=W(this.instrument.isAsGiven?this.data.summary:"Set on this page.");let s=this.instrument.motion();this.motion=s.around(n),this.readouts.take(this.motion,this.data,!0),this.build(),this.timebar.take(this.motion,!1,n),this.sharing.suggest(),this.room.keep(),this.address.changed()}build(){this.outgoing.push(...this.panels),document.documentElement.dataset.theme=this.theme.name,this.panels=this.data.panels.map(t=>{let n=this.changedPanel(t);return Object.assign(FL[t.type](this.motion,n,this.theme,wp),{type:t.type})}),this.panels.forEach((t,n)=>Xg(this.canvases[n],t,this.data,()=>this.draw()));let e=this.instrument&&!this.instrument.isAsGiven;this.plots.take(this.motion,e?{...this.data,scatters:[],plots:[]}:this.data,this.theme),this.draw()}changedPanel(e){return this.shaped&&e.type==="body"?{...e,surface:null,ellipsoid:null,changed:!0}:this.instrument&&!this.instrument.isAsGiven&&e.type==="sphere"?{...e,changed:!0,equilibria:null}:e}dress(e){this.theme=e,this.build()}show(e,t){this.now=this.motion.endless?{position:e,...this.motion.solvedAt(t)}:this.motion.at(e),this.timebar.playing||this.address.changed(),this.draw()}goTo(e){let t;try{t=this.windowAt(e)}catch(n){return this.timebar.pause(),Kt("refused").textContent=n.message,!1}return t!==this.motion?(this.motion=t,this.build(),this.timebar.take(t,!1,e)):this.timebar.goTo(e),!0}windowAt(e){let{times:t,count:n,endless:s}=this.motion;if(!Number.isFinite(e))throw new RangeError(`t must be a finite number of seconds; got ${Tn(e)}. Give a nearer time.`);if(s)return this.motion.around(e);if(e>=t[0]&&e<=t[n-1])return this.motion;if(this.instrument)return this.instrument.motion().around(e);throw new RangeError(`t must be from ${t[0]} to ${t[n-1]} s, where this motion has samples; got ${e}. Give a time between these.`)}draw(){this.waiting??=requestAnimationFrame(()=>this.drawNow())}drawNow(){cancelAnimationFrame(this.waiting),this.waiting=null,this.shapes=this.sizes();for(let e of this.panels)e.update(this.now);this.stage.draw(this.panels,this.canvases,this.theme),this.clear(),this.plots.draw(this.now),this.readouts.show(this.now),this.sharing.frame(),window.polhode.drawn+=1,window.polhode.firstPicture??=performance.now()}clear(){for(let e of this.outgoing)cy(e.scene);this.outgoing=[]}drawn(){return this.waiting&&this.drawNow(),this}sizes(){return this.canvases.map(e=>`${e.clientWidth} ${e.clientHeight}`).join()}listen(e,t){let n=s=>{let r=e.getBoundingClientRect();return[(s.clientX-r.left)/r.width*2-1,1-(s.clientY-r.top)/r.height*2]};e.addEventListener("pointerdown",s=>{let r=this.panels[t];if(s.button!==0||!r.grasp||!this.instrument?.kind.dragged||!r.grasp(n(s),e.clientWidth))return;s.stopImmediatePropagation(),this.timebar.pause(),e.setPointerCapture(s.pointerId);let o=l=>{let c=this.panels[t].under(n(l));c&&(this.now={...this.now,time:this.instrument.setting.epoch},this.instrument.point(c))},a=()=>{e.removeEventListener("pointermove",o);for(let l of["pointerup","pointercancel"])e.removeEventListener(l,a)};e.addEventListener("pointermove",o);for(let l of["pointerup","pointercancel"])e.addEventListener(l,a)},{capture:!0})}shot(e=null){e||this.drawn();let t=this.canvases[this.views.large],n=e??document.createElement("canvas");e||([n.width,n.height]=[t.width,t.height].map(l=>l-l%2));let s=n.getContext("2d");s.fillStyle=this.theme.ground,s.fillRect(0,0,n.width,n.height);let r=Math.min(n.width/t.width,n.height/t.height),[o,a]=[t.width*r,t.height*r];return s.drawImage(t,.5*(n.width-o),.5*(n.height-a),o,a),n}},lv=()=>window.matchMedia("(prefers-reduced-motion: reduce)").matches,OL=i=>ht(i.times);function BL(i){return{drawn:0,firstPicture:null,get count(){return i.motion.count},get times(){return i.motion.times},view:i.view,enlarge:e=>i.views.enlarge(e),shown:()=>({theme:i.theme.name,position:i.now.position,time:i.now.time}),seek(e){i.timebar.to(e),i.drawNow()},goTo(e){let t=i.goTo(e);return i.drawn(),t},get playing(){return i.timebar.playing},set:e=>i.instrument?.set(e)??!1,settings:()=>i.instrument?.kind.asSpec(i.instrument.setting)??null,state(e){let t=i.motion.endless?i.motion:i.instrument?.motion([e]),n=t?t.solvedAt(e):i.motion.at(i.motion.positionOf(e)),{w:s,x:r,y:o,z:a}=n.attitude??{};return{attitude:n.attitude?[s,r,o,a]:null,momentum:n.momentum?.toArray()??null}},spec:()=>i.instrument?.toml(i.motion.span)??null,plots:()=>i.drawn().plots.probe(),names:()=>i.drawn().panels.map(e=>e.boxes??[]),measure(e,...t){i.drawn();let n=i.panels.find(s=>s.type===e)?.probe();return n&&t.length?Object.fromEntries(t.map(s=>[s,n[s]])):n}}}try{let i=JSON.parse(Kt("motion").textContent);window.polhode={drawn:0,firstPicture:null};let e=new Yu;e.take(nl(window.location.hash).tables.lang),Kd(i.presets?i.presets[0]:i);let t=new Ap(i,e);window.polhode=BL(t),window.seek=n=>window.polhode.seek(n),t.draw(),!lv()&&t.motion.count>1&&t.motion.span>0&&requestAnimationFrame(()=>t.timebar.toggle())}catch(i){let e=Kt("failure");throw e.hidden=!1,e.textContent=W("The pictures cannot be drawn ({why}). They need a browser with WebGL 2.",{why:i.message}),i}})();
